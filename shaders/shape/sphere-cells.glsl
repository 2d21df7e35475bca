#include "arc-tangent.glsl"

// The surface lengths (U, V) of a sphere, counted in cells: arcs from the meridian of +z towards +x, and from the pole at +y
// down. Precision: f32.
vec2 sphereCells(Sphere s, vec3 p) {
  vec3 q = p - s.center;
  float fromAxis = sqrt(q.x * q.x + q.z * q.z);
  return s.cells * vec2(arcTangent(q.x, q.z), arcTangent(fromAxis, q.y));
}
