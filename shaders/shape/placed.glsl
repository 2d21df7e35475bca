// A ray in the own space of a placed shape, which meets it there. The map from the scene's frame is `unit` times the matrix
// with the rows x, y and z, none of which is longer than 1; both spaces have the camera as their origin, so nothing large
// cancels. Directions are normalised there, as the shapes expect it, and distances are divided by what that took.
// Source: e.g. P. Shirley and R. K. Morley, Realistic Ray Tracing (2003), ch. 12, on instances. Precision: f32; the
// direction where lengths differ widely as `splitDot`: next to something as large as a planet, one ulp of it matters.
#include "split-dot.glsl"

vec3 placedX(Placement s) {
#ifdef WIDE_RANGE
  return s.x + (s.x2 + s.x3);
#else
  return s.x;
#endif
}

vec3 placedY(Placement s) {
#ifdef WIDE_RANGE
  return s.y + (s.y2 + s.y3);
#else
  return s.y;
#endif
}

vec3 placedZ(Placement s) {
#ifdef WIDE_RANGE
  return s.z + (s.z2 + s.z3);
#else
  return s.z;
#endif
}

vec3 placedPoint(Placement s, vec3 o) {
  return s.unit * vec3(dotInOrder(placedX(s), o), dotInOrder(placedY(s), o), dotInOrder(placedZ(s), o));
}

// The unit direction in the own space, and how many of its lengths a length of the scene is along it. The place of a shape
// that is gone holds zeros, and so both are 0.
vec4 placedDirection(Placement s, vec3 d) {
#ifdef WIDE_RANGE
  vec3 e = vec3(splitDot(s.x, s.x2, s.x3, d), splitDot(s.y, s.y2, s.y3, d), splitDot(s.z, s.z2, s.z3, d));
#else
  vec3 e = vec3(dotInOrder(s.x, d), dotInOrder(s.y, d), dotInOrder(s.z, d));
#endif
  float size = sqrt(dotInOrder(e, e));
  return vec4(e / max(size, SMALLEST), s.unit * size);
}

// A distance in the scene's frame, for one along a ray of that rate.
float placedDistance(float t, float rate) {
  return mix(MISS, t / rate, t < MISS);
}

// The unit normal in the scene, on the same side of the surface: by the transpose of the map.
vec3 placedNormal(Placement s, vec3 n) {
  vec3 m = n.x * placedX(s) + n.y * placedY(s) + n.z * placedZ(s);
  return m / max(sqrt(dotInOrder(m, m)), SMALLEST);
}
