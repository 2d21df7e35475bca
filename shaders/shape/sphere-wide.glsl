// Ray against sphere where lengths differ so much that f32 does not hold a position: next to a planet's surface, or from very
// far away. The centre comes in parts (see split-parts.ts). See sphere.glsl. Precision: f32, where `exact` almost twice that.

#include "split-dot.glsl"

// What all rays from a point share: the way to the centre, the power |c|² - r² of the point, whether that is exact, and the
// point.
struct SphereFrom {
  vec3 c;
  float power;
  bool exact;
  vec3 o;
};

SphereFrom sphereFrom(Sphere s, vec3 o) {
  vec3 c = (s.center - o) + s.centerLow;
  float power = dot(c, c) - s.radius2;
  // Near the camera, what the power changes by on the way there: on a planet, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * s.radius2;
  return SphereFrom(c, mix(power, s.power - dot(o, s.center + c), near), near, o);
}

SphereFrom sphereFromCamera(Sphere s) {
  return SphereFrom(s.center, s.power, true, vec3(0.0));
}

vec2 sphereChord(Sphere s, SphereFrom from, vec3 d) {
  // Near the camera c·d is what is left of a planet's radius, and b² - power what is left of that at the horizon: there
  // the first is worked out to twice the precision, and d is as long as it is.
  float a = dotInOrder(d, d);
  float split = 2.0 * splitDot(s.half1, s.half2, s.half3, d) - dotInOrder(from.o, d);
  float b = mix(dot(from.c, d), split, from.exact);
  vec3 aside = from.c - (b / a) * d;
  float b2 = b * b;
  float r2 = a * s.radius2;
  return vec2(b, mix(r2 - a * dot(aside, aside), b2 - a * from.power, from.exact && b2 < r2));
}

// Like `curvature`, for a point that may not be quite on the sphere.
float sphereCurvature(Sphere s, SphereFrom from) {
  return sign(s.curvature) / sqrt(max(dot(from.c, from.c), SMALLEST));
}
