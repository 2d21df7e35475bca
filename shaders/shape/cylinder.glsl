// Ray against capped cylinder: the part of the line within the endless one, and between the caps. With p the part of the
// way to the base that is perpendicular to the axis w, A t² - 2 B t + k = 0 where A = |d × w|², B = p·d, k = |p|² - r²;
// its discriminant is B² - A k, or A r² - (d·(w × p))² where that cancels less (as for spheres, see sphere.glsl), and its
// roots are worked out without subtraction. For the camera p and k come from f64, k as a product. Precision: f32.
#include "shape/convex.glsl"
#include "split-dot.glsl"

// What all rays from a point share: p and k, and the ways along the axis to base and top.
struct CylinderFrom {
  vec3 p;
  float k;
  float toBase;
  float toTop;
#ifdef WIDE_RANGE
  // Near the camera: how far it is from there, perpendicular to the axis.
  bool near;
  vec3 o;
  // The way to the base.
  vec3 c;
#endif
};

vec3 cylinderAxis(Cylinder s) {
#ifdef WIDE_RANGE
  return s.axis + (s.axis2 + s.axis3);
#else
  return s.axis;
#endif
}

float cylinderAlongAxis(Cylinder s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.axis, s.axis2, s.axis3, v);
#else
  return dotInOrder(s.axis, v);
#endif
}

CylinderFrom cylinderFrom(Cylinder s, vec3 o) {
  vec3 w = cylinderAxis(s);
  vec3 c = s.base - o;
#ifdef WIDE_RANGE
  c += s.baseLow;
#endif
  vec3 p = cross(w, cross(c, w));
  float size = sqrt(dotInOrder(p, p));
  float k = (size - s.radius) * (size + s.radius);
  float toBase = cylinderAlongAxis(s, c);
#ifdef WIDE_RANGE
  // Near the camera, what changes on the way there: next to a large cylinder, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * s.radius * s.radius;
  vec3 aside = o - cylinderAlongAxis(s, o) * w;
  k = mix(k, s.k - dotInOrder(aside, s.p + p), near);
  bool nearCaps = dot(o, o) < 0.01 * dot(s.base, s.base);
  toBase = mix(toBase, s.toBase - cylinderAlongAxis(s, o), nearCaps);
  float toTop = mix(toBase + s.height, s.toTop - cylinderAlongAxis(s, o), nearCaps);
  return CylinderFrom(p, k, toBase, toTop, near, aside, c);
#else
  return CylinderFrom(p, k, toBase, toBase + s.height);
#endif
}

#ifdef WIDE_RANGE
// From far away, by the way to the base.
CylinderFrom cylinderFromFar(Cylinder s, vec3 c) {
  vec3 w = cylinderAxis(s);
  vec3 p = cross(w, cross(c, w));
  float size = sqrt(dotInOrder(p, p));
  float toBase = cylinderAlongAxis(s, c);
  float k = (size - s.radius) * (size + s.radius);
  return CylinderFrom(p, k, toBase, toBase + s.height, false, vec3(0.0), c);
}
#endif

CylinderFrom cylinderFromCamera(Cylinder s) {
#ifdef WIDE_RANGE
  return CylinderFrom(s.p, s.k, s.toBase, s.toTop, true, vec3(0.0), s.base);
#else
  return CylinderFrom(s.p, s.k, s.toBase, s.toTop);
#endif
}

// Where the line is inside of the endless cylinder.
vec2 cylinderSide(Cylinder s, CylinderFrom from, vec3 d) {
  vec3 w = cylinderAxis(s);
  vec3 n = cross(d, w);
  float a = dotInOrder(n, n);
  float b = dotInOrder(from.p, d);
#ifdef WIDE_RANGE
  b = mix(b, 2.0 * splitDot(s.half1, s.half2, s.half3, d) - dotInOrder(from.o, d), from.near);
#endif
  if (a == 0.0) return from.k <= 0.0 ? vec2(-MISS, MISS) : vec2(MISS, -MISS);
  float r2 = s.radius * s.radius;
  float m = dotInOrder(d, cross(w, from.p));
  float discriminant = b * b < a * r2 ? b * b - a * from.k : a * r2 - m * m;
  if (from.k < 0.0) discriminant = max(discriminant, 0.0);
  if (discriminant < 0.0) return vec2(MISS, -MISS);
  float q = b + (b < 0.0 ? -sqrt(discriminant) : sqrt(discriminant));
  vec2 t = q == 0.0 ? vec2(0.0) : vec2(from.k, q) / vec2(q, a);
  return vec2(min(t.x, t.y), max(t.x, t.y));
}

float cylinderDistance(Cylinder s, CylinderFrom from, vec3 d, float own) {
  float rate = cylinderAlongAxis(s, d);
  float start = 0.0;
#ifdef WIDE_RANGE
  start = approach(from.c, d, max(s.radius, s.height));
  if (start != 0.0) from = cylinderFromFar(s, from.c - start * d);
#endif
  vec2 caps = bothOf(belowPlane(rate, from.toTop), belowPlane(-rate, -from.toBase));
  return convexDistance(bothOf(cylinderSide(s, from, d), caps) + start, own);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float cylinderOcclusion(Cylinder s, CylinderFrom from, vec3 d, float limit, float own) {
  return limit - cylinderDistance(s, from, d, own);
}
#endif

// Whether a point is on a cap: further outside of that than of the side, or less inside.
bool cylinderOnCap(Cylinder s, CylinderFrom at) {
  return max(at.toBase, -at.toTop) > sqrt(dotInOrder(at.p, at.p)) - s.radius;
}

// The unit normal on the side that d comes from, times a weight.
vec3 cylinderNormal(Cylinder s, CylinderFrom at, vec3 d, float weight) {
  vec3 w = cylinderAxis(s);
  vec3 n = cylinderOnCap(s, at) ? w : at.p / max(sqrt(dotInOrder(at.p, at.p)), SMALLEST);
  return (dotInOrder(n, d) > 0.0 ? -weight : weight) * n;
}

#ifdef SIDES
// Whether the ray comes from outside: on the side the axis is ahead, and p leads there.
bool cylinderFront(Cylinder s, CylinderFrom at, vec3 d) {
  if (!cylinderOnCap(s, at)) return dotInOrder(at.p, d) > 0.0;
  return (cylinderAlongAxis(s, d) > 0.0) == (at.toBase > -at.toTop);
}
#endif

#ifdef CYLINDER_CHECKER
#include "arc-tangent.glsl"
// The surface lengths (U, V), counted in cells: on the side the arc from the tangent and the height above the base, on the
// caps the lengths along tangent and axis × tangent from the middle.
vec2 cylinderCells(Cylinder s, vec3 p) {
  CylinderFrom at = cylinderFrom(s, p);
  vec2 q = -vec2(dot(s.cellU, at.p), dot(s.cellV, at.p));
  return cylinderOnCap(s, at) ? q : vec2(arcTangent(q.y, q.x) * s.cellsAround, -at.toBase * s.cellsAlong);
}
#endif
