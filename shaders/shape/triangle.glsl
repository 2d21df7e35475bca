// Ray against triangle, watertight: a ray through an edge that two triangles share meets one of them at least.
// Source: S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: the corners are
// sheared so that the ray runs along z, and three edge functions in the plane decide. Both triangles compute the same
// products for a shared edge, in f32; the sign decides, whatever was rounded. The distance is that of the plane, packed
// from f64: where lengths differ widely with n·d as `splitDot`. It takes about 1.3 times as long as the common formula, which
// loses rays between triangles.
#include "split-dot.glsl"

// What all rays from a point share: the ways to the corners, and to the plane along the normal.
struct TriangleFrom {
  vec3 a;
  vec3 b;
  vec3 c;
  float height;
};

float triangleAlongNormal(Triangle s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.normal, s.normal2, s.normal3, v);
#else
  return dotInOrder(s.normal, v);
#endif
}

TriangleFrom triangleFrom(Triangle s, vec3 o) {
  vec3 a = s.a - o;
#ifdef WIDE_RANGE
  a += s.aLow;
  // Near the camera, what the height changes by on the way there: next to a large triangle, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * dot(s.a, s.a);
  float height = mix(triangleAlongNormal(s, a), s.height - triangleAlongNormal(s, o), near);
  return TriangleFrom(a, (s.b - o) + s.bLow, (s.c - o) + s.cLow, height);
#else
  return TriangleFrom(a, s.b - o, s.c - o, triangleAlongNormal(s, a));
#endif
}

TriangleFrom triangleFromCamera(Triangle s) {
  return TriangleFrom(s.a, s.b, s.c, s.height);
}

// The axes in turn, so that the one along which d is longest comes last.
vec3 longestLast(vec3 v, vec3 size) {
  bool x = size.x > max(size.y, size.z);
  return x ? v.yzx : (size.y > size.z ? v.zxy : v);
}

// A ray within the plane misses it. One that leaves the triangle (own = 1) never meets it again.
float triangleDistance(Triangle s, TriangleFrom from, vec3 d, float own) {
  vec3 size = abs(d);
  vec3 e = longestLast(d, size);
  vec2 shear = e.xy / e.z;
  vec3 a = longestLast(from.a, size);
  vec3 b = longestLast(from.b, size);
  vec3 c = longestLast(from.c, size);
  vec2 p = a.xy - shear * a.z;
  vec2 q = b.xy - shear * b.z;
  vec2 r = c.xy - shear * c.z;
  float u = r.x * q.y - r.y * q.x;
  float v = p.x * r.y - p.y * r.x;
  float w = q.x * p.y - q.y * p.x;
  bool inside = min(min(u, v), w) >= 0.0 || max(max(u, v), w) <= 0.0;
  float t = from.height / triangleAlongNormal(s, d);
  bool meets = inside && t > 0.0 && own < 0.5;
  return mix(MISS, t, meets && t < MISS);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float triangleOcclusion(Triangle s, TriangleFrom from, vec3 d, float limit, float own) {
  return limit - triangleDistance(s, from, d, own);
}
#endif

// The unit normal on the side that d comes from, times a weight.
vec3 triangleNormal(Triangle s, TriangleFrom at, vec3 d, float weight) {
  vec3 n = s.normal;
#ifdef WIDE_RANGE
  n += s.normal2 + s.normal3;
#endif
  return (triangleAlongNormal(s, d) > 0.0 ? -weight : weight) * n;
}

#ifdef SIDES
// Whether the ray comes from the side that the normal points to.
bool triangleFront(Triangle s, TriangleFrom at, vec3 d) {
  return triangleAlongNormal(s, d) <= 0.0;
}
#endif

#ifdef TRIANGLE_CHECKER
// The surface lengths (U, V) along the first edge and across it from the first corner, counted in cells.
vec2 triangleCells(Triangle s, vec3 p) {
  return vec2(s.startU + dot(s.cellU, p), s.startV + dot(s.cellV, p));
}
#endif
