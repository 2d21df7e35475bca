// Ray against torus, in f32, without the cancellations of the textbook quartic. Lengths are in ring units (s.unit of them
// in one of the frame), in which the ring's radius is 1/4 to 1/2; s counts from where the ray is nearest to the centre.
// With the distances `fromAxis` to the axis and `away` to the ring's centre line, the surface is where
//   power = away² - tube² = (away - tube) (away + tube)
// is 0, and power (power + 4 radius fromAxis), which has the same sign, is a quartic without a cubic term:
//   s⁴ + 2 h s² + 4 j s + …
// Its stationary points (two minima with a maximum between, or one minimum and the flattest point twice) come from the
// cubic s³ + h s + j. Around them the quartic has no (or hardly a) linear term. Its value there is worked out from `power`,
// so a ray that just grazes has its two roots as ± a square root, and no root is taken for another. From bounds by the
// single powers of v = |s - stationary point|, Newton's method needs at most 4 steps for 6 digits whatever the quartic;
// one on `power` itself gives all that f32 has.
// Measured on test/truth: within 4 roundings of the input at p99. No loops: see `direct.glsl`. The quartic is the usual one
// (E. Haines in A. Glassner, An Introduction to Ray Tracing, 1989, section 3.2); the way to solve it was made for this.

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

// A ray, from its point nearest to the centre: how high over the ring's plane, what is level with it (turned by a right
// angle), and how these grow. t = near + (s - rest), so that the digits of `near` and of s do not get into each other.
struct TorusLine {
  float near;
  float rest;
  float height;
  float climb;
  vec3 level;
  vec3 across;
};

TorusFrom torusFrom(Torus s, vec3 o) {
  vec3 c = s.unit * (s.center - o);
  float height = -dot(s.axis, c);
  vec3 level = -height * s.axis - c;
  float fromAxis = sqrt(dot(level, level));
  vec3 outwards = level / max(fromAxis, SMALLEST);
  // Not the difference of points, in which the ring's radius would cancel.
  vec3 away = height * s.axis + (fromAxis - s.radius) * outwards;
  float distance = sqrt(dot(away, away));
  float power = (distance - s.tube) * (distance + s.tube);
#ifdef WIDE_RANGE
  // Near the camera, what the power changes by on the way there: next to a huge ring, nothing large cancels in it.
  vec3 y = s.unit * o;
  vec3 flat_ = cross(y, s.axis);
  float flat2 = dot(flat_, flat_);
  vec3 start = cross(-s.unit * s.center, s.axis);
  float startFromAxis = sqrt(dot(start, start));
  float sum = max(fromAxis + startFromAxis, SMALLEST);
  float along = dot(start, flat_);
  float wider = (2.0 * along + flat2) / sum;
  float change = 2.0 * s.away * dot(s.out1 + s.out2 + s.out3, y) + dot(y, y);
  change += 2.0 * s.radius / sum * (wider * along / max(startFromAxis, SMALLEST) - flat2);
  bool near = dot(y, y) < 0.0625 * s.tube * s.tube;
  return TorusFrom(c, away, mix(power, s.power + change, near), fromAxis, false);
#else
  return TorusFrom(c, away, power);
#endif
}

TorusFrom torusFromCamera(Torus s) {
#ifdef WIDE_RANGE
  vec3 c = s.unit * s.center;
  vec3 turned = cross(c, s.axis);
  return TorusFrom(c, s.away * (s.out1 + s.out2 + s.out3), s.power, sqrt(dot(turned, turned)), true);
#else
  return torusFrom(s, vec3(0.0));
#endif
}

TorusLine torusLine(Torus s, TorusFrom from, vec3 d) {
  float d2 = dot(d, d);
  float near = dot(from.c, d) / d2;
  vec3 x = near * d - from.c;
  float rest = dot(x, d) / d2;
  x -= rest * d;
  return TorusLine(near, rest, dot(x, s.axis), dot(d, s.axis), cross(x, s.axis), cross(d, s.axis));
}

// At s on the line: the power, and the distance from the axis.
vec2 torusAt(Torus s, TorusLine line, float at) {
  vec3 level = line.level + at * line.across;
  float fromAxis = sqrt(dot(level, level));
  float height = line.height + at * line.climb;
  float beside = fromAxis - s.radius;
  float distance = sqrt(beside * beside + height * height);
  return vec2((distance - s.tube) * (distance + s.tube), fromAxis);
}

float torusQuartic(Torus s, TorusLine line, float at) {
  vec2 place = torusAt(s, line, at);
  return place.x * (place.x + 4.0 * s.radius * place.y);
}

// One step of Newton's method on the power.
float torusPolished(Torus s, TorusLine line, float at) {
  vec2 place = torusAt(s, line, at);
  float widening = dot(line.level + at * line.across, line.across) / max(place.y, SMALLEST);
  float slope = 2.0 * ((place.y - s.radius) * widening + (line.height + at * line.climb) * line.climb);
  return mix(at, at - place.x / slope, abs(slope) > SMALLEST);
}

float torusCubicStep(float s, float h, float j) {
  return s - (s * (s * s + h) - j) / max(3.0 * s * s + h, SMALLEST);
}

// Where the quartic is stationary, in order.
vec3 torusStationary(float h, float j) {
  // The root of s³ + h s = |j| that is not below 0. Its bounds are good within a factor of 2.
  float size = abs(j);
  float square = pow(max(size, SMALLEST), 0.666666667);
  float s = mix(size / (abs(h) + square), sqrt(abs(h) + square), h < 0.0);
  s = torusCubicStep(s, h, size);
  s = torusCubicStep(s, h, size);
  s = torusCubicStep(s, h, size);
  s = torusCubicStep(s, h, size);
  float root = sqrt(max(-3.0 * s * s - 4.0 * h, 0.0));
  float other = 0.5 * (s + root);
  float middle = mix(0.5 * s, size / (s * other), root > 0.0);
  return mix(vec3(-other, -middle, s), vec3(-s, middle, other), bvec3(j > 0.0));
}

// How far from a stationary point the quartic has changed by `level`: linear v + v² ((v + shift)² + bend), times `sign`.
float torusChangeStep(float v, float level, float linear, float shift, float bend, float sign) {
  float y = v + shift;
  float w = sign * (y * y + bend);
  float change = v * (linear + v * w) - level;
  return clamp(v - change / max(linear + 2.0 * v * (w + v * sign * y), SMALLEST), 0.0, 2.0);
}

#ifdef WIDE_RANGE
// The quartic in t, next to where the ray starts.
struct TorusTaylor {
  float k0;
  float k1;
  float k2;
  float k3;
  float k4;
};

TorusTaylor torusTaylor(Torus s, TorusFrom from, TorusLine line, vec3 d) {
  float ring = 2.0 * s.radius * from.fromAxis;
  float slope = mix(dotInOrder(from.away, d), s.away * splitDot(s.out1, s.out2, s.out3, d), from.camera);
  float b = -dot(from.c, d);
  float d2 = dot(d, d);
  float r2 = s.radius * s.radius;
  return TorusTaylor(
    from.power * (from.power + 2.0 * ring),
    4.0 * (from.power * b + ring * slope),
    2.0 * d2 * (from.power + ring) + 4.0 * (b * b - r2 * dot(line.across, line.across)),
    4.0 * d2 * b,
    d2 * d2
  );
}

float torusTaylorAt(TorusTaylor k, float t) {
  return k.k0 + t * (k.k1 + t * (k.k2 + t * (k.k3 + t * k.k4)));
}

float torusTaylorStep(TorusTaylor k, float t) {
  float slope = k.k1 + t * (2.0 * k.k2 + t * (3.0 * k.k3 + t * (4.0 * k.k4)));
  return mix(t, t - torusTaylorAt(k, t) / slope, abs(slope) > SMALLEST);
}
#endif

// The distance to the torus, or MISS. A ray that leaves the torus itself (own = 1) has its own root on the slope of the
// quartic on which it starts, and goes on to the next.
float torusDistance(Torus s, TorusFrom from, vec3 d, float own) {
  TorusLine line = torusLine(s, from, d);
  float ring2 = 2.0 * s.radius * s.radius;
  float aside2 = line.height * line.height + dot(line.level, line.level);
  float h = aside2 + s.squares - ring2 * dot(line.across, line.across);
  float j = -ring2 * dot(line.level, line.across);
  vec3 stationary = torusStationary(h, j);
  float first = stationary.x;
  float peak = stationary.y;
  float second = stationary.z;
  float start = line.rest - line.near;
  vec3 values = vec3(
    torusQuartic(s, line, first),
    torusQuartic(s, line, peak),
    torusQuartic(s, line, second)
  );
#ifdef WIDE_RANGE
  TorusTaylor taylor = torusTaylor(s, from, line, d);
  vec3 places = stationary - start;
  vec3 nearby = taylor.k0 + places * (taylor.k1 + places * (taylor.k2 + places * (taylor.k3 + places * taylor.k4)));
  values = mix(values, nearby, lessThan(abs(places), vec3(0.25 * s.tube)));
#endif
  bool leaves = own > 0.5;
  bool inside = (leaves ? dot(from.away, d) : from.power) < 0.0;
  // The valley that the ray gets into on its near side, or out of on its far side.
  bool beforePeak = start < mix(peak, 0.5 * (first + peak), leaves);
  bool beforeSecond = start < mix(second, 0.5 * (peak + second), leaves);
  bool atFirst = inside ? beforePeak && values.y >= 0.0 : !leaves && start < first && values.x < 0.0;
  bool hits = inside || atFirst || (beforeSecond && values.z < 0.0);
  float valley = mix(second, first, atFirst);
  float depth = -mix(values.z, values.x, atFirst);
  // Between valley and peak, from whichever is nearer in value.
  bool inner = atFirst == inside;
  bool down = inner && values.y < depth;
  float center = mix(valley, peak, down);
  float level = max(mix(depth, values.y, down), 0.0);
  float sign = down ? -1.0 : 1.0;
  float towards = inside == down ? -1.0 : 1.0;

  float linear = max(4.0 * sign * towards * (center * (center * center + h) + j), 0.0);
  float shift = 2.0 * towards * center;
  float bend = 2.0 * (center * center + h);
  float twist = max(2.0 * sign * shift, SMALLEST);
  float curvature = max(sign * (shift * shift + bend), SMALLEST);
  float bound = mix(sqrt(sqrt(level)), 0.6 * abs(peak - valley), inner);
  float v = min(min(bound, level / max(linear, SMALLEST)), min(sqrt(level / curvature), pow(max(level / twist, SMALLEST), 0.333333333)));
  v = torusChangeStep(v, level, linear, shift, bend, sign);
  v = torusChangeStep(v, level, linear, shift, bend, sign);
  v = torusChangeStep(v, level, linear, shift, bend, sign);
  v = torusChangeStep(v, level, linear, shift, bend, sign);
  float at = torusPolished(s, line, center + towards * v);
  float t = line.near + (at - line.rest);
#ifdef WIDE_RANGE
  float close = torusTaylorStep(taylor, torusTaylorStep(taylor, t));
  t = mix(t, close, abs(t) < 0.25 * s.tube);
#endif
  // A root that rounding has put behind is met at once.
  return mix(MISS, max(t, SMALLEST) / s.unit, hits);
}

#ifdef SHADOWS
// Above 0 where the torus is in the way within `limit`.
float torusOcclusion(Torus s, TorusFrom from, vec3 d, float limit, float own) {
  return limit - torusDistance(s, from, d, own);
}
#endif

// The unit normal on the side that the ray d comes from, times a weight.
vec3 torusNormal(Torus s, TorusFrom from, vec3 d, float weight) {
  // Where no object was met, the point is so far away that squares leave the range.
  vec3 away = clamp(from.away, -1.0, 1.0);
  float turned = mix(weight, -weight, dot(away, d) > 0.0);
  return (turned / max(sqrt(dot(away, away)), SMALLEST)) * away;
}

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
