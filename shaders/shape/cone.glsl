// Ray against capped cone: the part of the line within one nappe of the endless double cone, and before the base. With v
// the way to the tip, w the axis from there to the base, k the slope (radius over height), hv = w·v and p = v - hv w,
// A t² - 2 B t + C = 0 where A = |d × w|² - k² (d·w)², B = d·(p - k² hv w), C = |p|² - k² hv², the differences of squares
// as products; the discriminant is B² - A C, or k² |M⊥|² - (p·(d × w))² with M = v × d where that cancels less.
// For the camera p, C and the vector of B come from f64, with WIDE_RANGE near it too. Precision: f32.
#include "shape/convex.glsl"
#include "split-dot.glsl"

// What all rays from a point share.
struct ConeFrom {
  vec3 v;
  vec3 p;
  float hv;
  float c;
  float toBase;
#ifdef WIDE_RANGE
  // Near the camera, and what the vector of B changes by on the way from there.
  bool near;
  vec3 change;
#endif
};

vec3 coneAxis(Cone s) {
#ifdef WIDE_RANGE
  return s.axis + (s.axis2 + s.axis3);
#else
  return s.axis;
#endif
}

float coneAlongAxis(Cone s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.axis, s.axis2, s.axis3, v);
#else
  return dotInOrder(s.axis, v);
#endif
}

#ifdef WIDE_RANGE
// Times the vector of B at the camera.
float coneAlongGradient(Cone s, vec3 v) {
  return s.gradientScale * splitDot(s.gradient1, s.gradient2, s.gradient3, v);
}
#endif

// By the way to the tip.
ConeFrom coneFromTip(Cone s, vec3 v) {
  vec3 w = coneAxis(s);
  float hv = coneAlongAxis(s, v);
  vec3 p = cross(w, cross(v, w));
  float size = sqrt(dotInOrder(p, p));
  float across = s.slope * abs(hv);
  float c = (size - across) * (size + across);
#ifdef WIDE_RANGE
  return ConeFrom(v, p, hv, c, hv + s.height, false, vec3(0.0));
#else
  return ConeFrom(v, p, hv, c, hv + s.height);
#endif
}

// The way to the base is not that by the tip: from a point next to a large base, almost nothing would be left of that.
ConeFrom coneFrom(Cone s, vec3 o) {
#ifdef WIDE_RANGE
  ConeFrom from = coneFromTip(s, (s.tip - o) + s.tipLow);
  // Near the camera, what changes on the way there: next to a large cone, nothing large cancels in it.
  float along = coneAlongAxis(s, o);
  bool nearBase = dot(o, o) < 0.01 * dot(s.base, s.base);
  from.toBase = mix(coneAlongAxis(s, (s.base - o) + s.baseLow), s.toBase - along, nearBase);
  from.near = dot(o, o) < 0.01 * dot(s.tip, s.tip);
  vec3 w = coneAxis(s);
  from.change = cross(w, cross(o, w)) - s.slope * s.slope * along * w;
  float c = s.c + (dotInOrder(o, from.change) - 2.0 * coneAlongGradient(s, o));
  from.c = mix(from.c, c, from.near);
  return from;
#else
  ConeFrom from = coneFromTip(s, s.tip - o);
  from.toBase = coneAlongAxis(s, s.base - o);
  return from;
#endif
}

ConeFrom coneFromCamera(Cone s) {
#ifdef WIDE_RANGE
  return ConeFrom(s.tip, s.p, s.hv, s.c, s.toBase, true, vec3(0.0));
#else
  return ConeFrom(s.tip, s.p, s.hv, s.c, s.toBase);
#endif
}

// Where the line is inside of the nappe that holds the base.
vec2 coneNappe(Cone s, ConeFrom from, vec3 d, float dw) {
  vec3 w = coneAxis(s);
  vec3 n = cross(d, w);
  float size = sqrt(dotInOrder(n, n));
  float across = s.slope * abs(dw);
  float a = (size - across) * (size + across);
  float b = dotInOrder(d, from.p) - s.slope * s.slope * from.hv * dw;
#ifdef WIDE_RANGE
  b = mix(b, coneAlongGradient(s, d) - dotInOrder(from.change, d), from.near);
#endif
  vec3 m = cross(from.v, d);
  vec3 aside = m - dotInOrder(m, w) * w;
  float one = s.slope * s.slope * dotInOrder(aside, aside);
  float other = dotInOrder(from.p, n);
  bool plain = b * b + abs(a * from.c) < one + other * other;
  float discriminant = plain ? b * b - a * from.c : one - other * other;
  if (a <= 0.0 || from.c < 0.0) discriminant = max(discriminant, 0.0);
  if (discriminant < 0.0) return vec2(MISS, -MISS);
  float q = b + (b < 0.0 ? -sqrt(discriminant) : sqrt(discriminant));
  float first = q == 0.0 ? 0.0 : from.c / q;
  // A line along the cone meets it once; the other crossing is endlessly far, on the other nappe if this one is ahead.
  float second = a == 0.0 ? (q < 0.0 ? MISS : -MISS) : q / a;
  vec2 t = vec2(min(first, second), max(first, second));
  if (a > 0.0) return b * dw - a * from.hv >= 0.0 ? t : vec2(MISS, -MISS);
  return dw > 0.0 ? vec2(t.y, MISS) : vec2(-MISS, t.x);
}

float coneDistance(Cone s, ConeFrom from, vec3 d, float own) {
  float dw = coneAlongAxis(s, d);
  float start = 0.0;
#ifdef WIDE_RANGE
  start = approach(from.v, d, max(1.0, s.slope) * s.height);
  if (start != 0.0) from = coneFromTip(s, from.v - start * d);
#endif
  return convexDistance(bothOf(coneNappe(s, from, d, dw), belowPlane(dw, from.toBase)) + start, own);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float coneOcclusion(Cone s, ConeFrom from, vec3 d, float limit, float own) {
  return limit - coneDistance(s, from, d, own);
}
#endif

// Whether a point is on the base: further outside of that than of the side, or less inside.
bool coneOnBase(Cone s, ConeFrom at) {
  float outside = sqrt(dotInOrder(at.p, at.p)) + s.slope * at.hv;
  return -at.toBase > outside / sqrt(1.0 + s.slope * s.slope);
}

// The unit normal on the side that d comes from, times a weight; at the tip, where there is none, the axis.
vec3 coneNormal(Cone s, ConeFrom at, vec3 d, float weight) {
  vec3 w = coneAxis(s);
  float size = sqrt(dotInOrder(at.p, at.p));
  vec3 side = (s.slope * w + at.p / max(size, SMALLEST)) / sqrt(1.0 + s.slope * s.slope);
  vec3 n = coneOnBase(s, at) || size < SMALLEST ? w : side;
  return (dotInOrder(n, d) > 0.0 ? -weight : weight) * n;
}

#ifdef SIDES
// Whether the ray comes from outside: the axis leads out of the base, the normal of `coneNormal` into the side.
bool coneFront(Cone s, ConeFrom at, vec3 d) {
  if (coneOnBase(s, at)) return coneAlongAxis(s, d) <= 0.0;
  float size = sqrt(dotInOrder(at.p, at.p));
  return s.slope * coneAlongAxis(s, d) * size + dotInOrder(at.p, d) > 0.0;
}
#endif

#ifdef CONE_CHECKER
#include "arc-tangent.glsl"
// The surface lengths (U, V), counted in cells: on the side the arc from the tangent at this height and the length up from
// the base, on the base the lengths along tangent and axis × tangent from the middle.
vec2 coneCells(Cone s, vec3 p) {
  ConeFrom at = coneFrom(s, p);
  vec2 q = -vec2(dot(s.cellU, at.p), dot(s.cellV, at.p));
  float cellsAround = sqrt(dot(q, q));
  return coneOnBase(s, at) ? q : vec2(arcTangent(q.y, q.x) * cellsAround, at.toBase * s.cellsAlong);
}
#endif
