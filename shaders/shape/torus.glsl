// Ray against torus, in f32, for directions of unit length up to rounding.
// In ring units, of which the ring's radius is 1/4 to 1/2; s counts from where the ray is nearest to the centre. With the
// distances `fromAxis` from the axis and `away` from the ring's centre line, the surface is where
//   power = away² - tube² = (away - tube) (away + tube)
// is 0; and power (power + 4 radius fromAxis), which has the same sign, is a quartic without a cubic term:
//   s⁴ + 2 h s² + 4 j s + …
// Source of the quartic: P. Hanrahan in A. Glassner (ed.), An Introduction to Ray Tracing (1989), section 3.2. Its roots
// are not taken from it as it stands, which loses half of the digits where a ray grazes:
// - The cubic s³ + h s + j has its stationary points: minimum, maximum, minimum; or a minimum, and twice the flattest point.
// - The signs of `power` there, worked out without cancellation, tell between which two of them the root is.
// - Seen from one of them the quartic has hardly a linear term, so a ray that grazes has its roots as ± a square root.
//   From the least of the bounds that its single powers set, Newton's method gets there in 3 steps, or nearly so.
// - One step on `power` itself gets what f32 has to give. No step goes beyond what a stationary point next to it allows:
//   what rounding makes of a ray that grazes may have no root at all.
// That takes about 1.4 times as long as the closed formula of textbooks. Measured by leaving parts out, of all the time of a
// picture: the stationary points take 20 %, the choice between them 15 %, the powers there 13 %, Newton's method for the root
// 10 %, the last step 4 to 8 %. Fewer steps would save 3 %, and change pixels by a hundredth. Shadow rays, which need no root,
// do without one. A cheaper form that keeps the limits is not known.
// Measured with the ground truth: 99 % within 8 times what one rounding of the input may change, and all within 10, by that one
// of two software renderers that is worse; and what rays that graze meet is within 3 roundings of the torus's reach of it.
// Precision: f32. There are no loops, for what `direct.glsl` says of them.

#include "shape/torus-quartic.glsl"
#ifdef TORUS_CHECKER
#include "arc-tangent.glsl"
#endif
#ifdef WIDE_RANGE
#include "split-dot.glsl"
#endif

// What all rays from a point share: the way to the centre, that to the point from the ring's centre line, the power.
struct TorusFrom {
  vec3 c;
  vec3 away;
  float power;
#ifdef WIDE_RANGE
  float fromAxis;
  bool camera;
#endif
};

#ifdef WIDE_RANGE
// The power at y from the camera. What it changes by on the way there: next to a huge ring, nothing large cancels in it.
float torusPowerNearCamera(Torus s, vec3 y, float fromAxis) {
  vec3 c = s.unit * s.center;
  vec3 start = cross(s.axis, c);
  vec3 way = cross(y, s.axis);
  float startFromAxis = sqrt(dot(start, start));
  float sum = max(fromAxis + startFromAxis, SMALLEST);
  float along = dot(start, way);
  float way2 = dot(way, way);
  float widening = (2.0 * along + way2) / sum;
  float bent = widening * along / max(startFromAxis, SMALLEST) - way2;
  float straight = 2.0 * s.away * dot(s.out1 + s.out2 + s.out3, y);
  return s.power + (straight + dot(y, y) + 2.0 * s.radius / sum * bent);
}
#endif

TorusFrom torusFrom(Torus s, vec3 o) {
  // Where nothing was met, o is so far away that squares would leave the range.
  vec3 c = clamp(s.unit * (s.center - o), -1e17, 1e17);
  float height = -dot(s.axis, c);
  vec3 level = -height * s.axis - c;
  float fromAxis = sqrt(dot(level, level));
  float beside = fromAxis - s.radius;
  vec3 away = height * s.axis + (beside / max(fromAxis, SMALLEST)) * level;
  float distance = sqrt(beside * beside + height * height);
  float power = (distance - s.tube) * (distance + s.tube);
#ifdef WIDE_RANGE
  vec3 y = s.unit * o;
  bool near = dot(y, y) < 0.0625 * s.tube * s.tube;
  return TorusFrom(c, away, mix(power, torusPowerNearCamera(s, y, fromAxis), near), fromAxis, false);
#else
  return TorusFrom(c, away, power);
#endif
}

// The camera, whose power and way from the centre line were worked out in f64 where that matters.
TorusFrom torusFromCamera(Torus s) {
#ifdef WIDE_RANGE
  vec3 c = s.unit * s.center;
  vec3 turned = cross(c, s.axis);
  return TorusFrom(c, s.away * (s.out1 + s.out2 + s.out3), s.power, sqrt(dot(turned, turned)), true);
#else
  return torusFrom(s, vec3(0.0));
#endif
}

// A ray from its point nearest to the centre: how high that is over the ring's plane, what of it is level with the plane
// (turned by a right angle), and how these grow with s. t = near + (s - rest): the digits of s do not get lost in `near`.
struct TorusLine {
  float near;
  float rest;
  float height;
  float climb;
  vec3 level;
  vec3 across;
};

TorusLine torusLine(Torus s, TorusFrom from, vec3 d) {
  float d2 = dot(d, d);
  float near = dot(from.c, d) / d2;
  vec3 x = near * d - from.c;
  float rest = dot(x, d) / d2;
  x -= rest * d;
  return TorusLine(near, rest, dot(x, s.axis), dot(d, s.axis), cross(x, s.axis), cross(d, s.axis));
}

// At a place on the line: the power, and the distance from the axis.
vec2 torusAt(Torus s, TorusLine line, float place) {
  vec3 level = line.level + place * line.across;
  float fromAxis = sqrt(dot(level, level));
  float beside = fromAxis - s.radius;
  float height = line.height + place * line.climb;
  float distance = sqrt(beside * beside + height * height);
  return vec2((distance - s.tube) * (distance + s.tube), fromAxis);
}

float torusQuartic(Torus s, TorusLine line, float place) {
  vec2 at = torusAt(s, line, place);
  return at.x * (at.x + 4.0 * s.radius * at.y);
}

// One step of Newton's method on the power, which goes no farther than the place is from the stationary point `center`: next
// to one there is no slope, and what rounding makes of power and slope may differ from what it made of the level there.
float torusPowerStep(Torus s, TorusLine line, float place, float center) {
  vec2 at = torusAt(s, line, place);
  float widening = dot(line.level + place * line.across, line.across) / max(at.y, SMALLEST);
  float slope = 2.0 * ((at.y - s.radius) * widening + (line.height + place * line.climb) * line.climb);
  float most = abs(place - center);
  return mix(place, place - clamp(at.x / slope, -most, most), abs(slope) > SMALLEST);
}

#ifdef WIDE_RANGE
// The quartic in t: a constant and four factors. Good next to where the ray starts.
struct TorusTaylor {
  float k0;
  vec4 k;
};

TorusTaylor torusTaylor(Torus s, TorusFrom from, TorusLine line, vec3 d) {
  float ring = 2.0 * s.radius * from.fromAxis;
  float slope = mix(dot(from.away, d), s.away * splitDot(s.out1, s.out2, s.out3, d), from.camera);
  float b = -dot(from.c, d);
  float d2 = dot(d, d);
  float across = s.radius * s.radius * dot(line.across, line.across);
  vec4 k = vec4(
    4.0 * (from.power * b + ring * slope),
    2.0 * d2 * (from.power + ring) + 4.0 * (b * b - across),
    4.0 * d2 * b,
    d2 * d2
  );
  return TorusTaylor(from.power * (from.power + 2.0 * ring), k);
}

vec3 torusTaylorAt(TorusTaylor taylor, vec3 t) {
  vec4 k = taylor.k;
  return taylor.k0 + t * (k.x + t * (k.y + t * (k.z + t * k.w)));
}

// To the root of the parabola at t, on the side of its vertex that is searched; to the vertex, where rounding has left no
// root. (Newton's method would leave a ray that grazes for anywhere.) Not from next to the start, `within`, to elsewhere.
float torusTaylorStep(TorusTaylor taylor, TorusSearch search, float within, float t) {
  vec4 k = taylor.k;
  float rise = search.rising * (taylor.k0 + t * (k.x + t * (k.y + t * (k.z + t * k.w))));
  float slope = search.rising * search.towards * (k.x + t * (2.0 * k.y + t * (3.0 * k.z + t * (4.0 * k.w))));
  float bend = search.rising * (k.y + t * (3.0 * k.z + t * (6.0 * k.w)));
  float square = slope * slope - 4.0 * bend * rise;
  float root = sqrt(max(square, 0.0));
  bool slopes = slope > 0.0 && square > 0.0;
  float way = slopes ? -2.0 * rise / (slope + root) : (root - slope) / max(2.0 * bend, SMALLEST);
  float next = t + search.towards * way;
  return mix(t, next, max(abs(t), abs(next)) < within);
}
#endif

// What is known of a line that comes near the torus before any root is: s⁴ + 2 h s² + 4 j s + …, where it is stationary,
// where the ray starts, and where to look.
struct TorusQuartic {
  float h;
  float j;
  vec3 stationary;
  float start;
  TorusSearch search;
};

TorusQuartic torusQuarticOf(Torus s, TorusFrom from, TorusLine line, float aside2, vec3 d, bool leaves) {
  float ring2 = 2.0 * s.radius * s.radius;
  float h = aside2 + s.squares - ring2 * dot(line.across, line.across);
  float j = -ring2 * dot(line.level, line.across);
  float start = line.rest - line.near;
  vec3 stationary = torusStationary(h, j);
  vec3 values = vec3(
    torusQuartic(s, line, stationary.x),
    torusQuartic(s, line, stationary.y),
    torusQuartic(s, line, stationary.z)
  );
#ifdef WIDE_RANGE
  vec3 places = stationary - start;
  values = mix(values, torusTaylorAt(torusTaylor(s, from, line, d), places), lessThan(abs(places), vec3(0.25 * s.tube)));
#endif
  bool inside = mix(from.power, dot(from.away, d), leaves) < 0.0;
  return TorusQuartic(h, j, stationary, start, torusSearch(stationary, values, start, inside, leaves));
}

// The distance t in ring units, or MISS, for a line that comes near the torus.
float torusNearest(Torus s, TorusFrom from, TorusLine line, float aside2, vec3 d, bool leaves) {
  TorusQuartic quartic = torusQuarticOf(s, from, line, aside2, d, leaves);
  float root = torusRoot(quartic.search, quartic.h, quartic.j);
  float t = line.near + (torusPowerStep(s, line, root, quartic.search.center) - line.rest);
#ifdef WIDE_RANGE
  TorusTaylor taylor = torusTaylor(s, from, line, d);
  float within = 0.25 * s.tube;
  t = torusTaylorStep(taylor, quartic.search, within, torusTaylorStep(taylor, quartic.search, within, t));
#endif
  // A root that rounding has put behind the start is met at once.
  return mix(MISS, max(t, SMALLEST), quartic.search.hits);
}

// How far the line is aside of the centre, squared.
float torusAside2(TorusLine line) {
  return line.height * line.height + dot(line.level, line.level);
}

// Whether a line comes near the torus, with room for rounding.
bool torusNear(Torus s, float aside2) {
  float reach = s.radius + s.tube;
  return aside2 < 1.001 * reach * reach;
}

// The distance to the torus, or MISS. A ray that leaves the torus itself (own = 1) may meet it again.
float torusDistance(Torus s, TorusFrom from, vec3 d, float own) {
  TorusLine line = torusLine(s, from, d);
  float aside2 = torusAside2(line);
  float t = MISS;
  if (torusNear(s, aside2)) t = torusNearest(s, from, line, aside2, d, own > 0.5);
  return mix(MISS, t / s.unit, t < MISS);
}

#ifdef SHADOWS
// Above 0 where the torus is in the way within `limit`.
#ifdef WIDE_RANGE
float torusOcclusion(Torus s, TorusFrom from, vec3 d, float limit, float own) {
  return limit - torusDistance(s, from, d, own);
}
#else
// No root is needed for that: between a peak and a valley next to it, the power at the limit tells whether the root is before
// that.
float torusOcclusion(Torus s, TorusFrom from, vec3 d, float limit, float own) {
  TorusLine line = torusLine(s, from, d);
  float aside2 = torusAside2(line);
  TorusQuartic quartic = torusQuarticOf(s, from, line, aside2, d, own > 0.5);
  float end = quartic.start + s.unit * limit;
  float power = torusAt(s, line, end).x;
  TorusSearch search = quartic.search;
  return search.hits && torusNear(s, aside2) && end > search.after && (end > search.before || power * search.sense > 0.0) ? 1.0 : -1.0;
}
#endif
#endif

// The unit normal on the side that the ray d comes from, times a weight.
vec3 torusNormal(Torus s, TorusFrom from, vec3 d, float weight) {
  float turned = mix(weight, -weight, dot(from.away, d) > 0.0);
  return (turned / max(sqrt(dot(from.away, from.away)), SMALLEST)) * from.away;
}

#ifdef SIDES
// Whether the ray comes from outside.
bool torusFront(Torus s, TorusFrom from, vec3 d) {
  return dot(from.away, d) <= 0.0;
}
#endif

#ifdef TORUS_CHECKER
// The surface lengths (U, V), counted in cells: arcs around the axis on the ring's centre line, from the tangent, and
// around the tube from its outermost circle.
vec2 torusCells(Torus s, vec3 p) {
  vec3 x = s.unit * (p - s.center);
  float along = dot(x, s.tangent);
  float aside = dot(x, cross(s.axis, s.tangent));
  float beside = sqrt(along * along + aside * aside) - s.radius;
  return vec2(s.cellsU * arcTangent(aside, along), s.cellsV * arcTangent(dot(x, s.axis), beside));
}
#endif
