// Directions around an axis, all equally likely: in a cone whose half-angle has the cosine 1 - cone, which is packed, or
// worked out, without cancelling, so that the smallest cones have their right solid angle. Precision: f32.
#include "circle.glsl"
#include "tangents.glsl"

const float TWO_PI = 6.28318530718;

// Per solid angle.
float conePdf(float cone) {
  return 1.0 / max(TWO_PI * cone, SMALLEST);
}

// A unit vector in the cone around a unit axis.
vec3 coneDirection(vec3 axis, float cone, vec2 u) {
  float below = u.x * cone;
  vec3 x;
  vec3 y;
  tangents(axis, x, y);
  // 1 - cos² = (1 - cos)(1 + cos)
  vec2 aside = sqrt(below * (2.0 - below)) * circle(u.y);
  return (axis - below * axis) + (aside.x * x + aside.y * y);
}
