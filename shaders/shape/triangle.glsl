// Ray against triangle, watertight: a ray through an edge that two triangles share meets one of them at least.
// Source: S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: the corners are
// sheared so that the ray runs along z, and three edge functions in the plane decide. Both triangles compute the same
// products for a shared edge, in f32; the sign decides, whatever was rounded. The distance is that of the plane, packed
// from f64: where lengths differ widely with n·d as `splitDot`. It takes no longer than the common formula, which loses rays
// between triangles: there are no branches. (Branches for the order of the axes made SwiftShader compile for minutes.) To work
// the `TriangleRay` out once for all triangles brought nothing when it was measured. Precision: f32.
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

// What all triangles ask of a ray: its direction, and two vectors across it, of which one component is 1 and another 0. The
// products of a corner with these are its place in the plane along the two axes in which the ray is less long, sheared.
struct TriangleRay {
  vec3 d;
  vec3 first;
  vec3 second;
};

TriangleRay triangleRay(vec3 d) {
  vec3 size = abs(d);
  float x = float(size.x > max(size.y, size.z));
  float y = (1.0 - x) * float(size.y > size.z);
  vec3 longest = vec3(x, y, 1.0 - x - y);
  vec2 shear = vec2(dotInOrder(longest.zxy, d), dotInOrder(longest.yzx, d)) / dotInOrder(longest, d);
  return TriangleRay(d, longest.zxy - shear.x * longest, longest.yzx - shear.y * longest);
}

vec2 triangleSheared(TriangleRay ray, vec3 corner) {
  return vec2(dotInOrder(ray.first, corner), dotInOrder(ray.second, corner));
}

// A ray within the plane misses it. One that leaves the triangle (own = 1) never meets it again.
float triangleDistance(Triangle s, TriangleFrom from, vec3 d, float own) {
  TriangleRay ray = triangleRay(d);
  vec2 p = triangleSheared(ray, from.a);
  vec2 q = triangleSheared(ray, from.b);
  vec2 r = triangleSheared(ray, from.c);
  float u = r.x * q.y - r.y * q.x;
  float v = p.x * r.y - p.y * r.x;
  float w = q.x * p.y - q.y * p.x;
  float inside = max(min(min(u, v), w), -max(max(u, v), w));
  float t = from.height / triangleAlongNormal(s, ray.d);
  return mix(MISS, t, inside >= 0.0 && min(t, 0.5 - own) > 0.0);
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
