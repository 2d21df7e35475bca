// Ray against sphere without cancellation, for unit directions and points relative to the camera.
// Source: E. Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7 (2019): the
// discriminant from the part of the centre perpendicular to the ray; the roots without subtraction. There are no branches:
// a driver may run both sides of one anyway. Precision: f32.

#if defined(WIDE_RANGE)
#include "shape/sphere-wide.glsl"
#elif defined(CLOSE_SPHERE)
#include "shape/sphere-close.glsl"
#else
// What all rays from a point share: the way to the centre, and the power |c|² - r² of the point.
struct SphereFrom {
  vec3 c;
  float power;
};

SphereFrom sphereFrom(Sphere s, vec3 o) {
  vec3 c = s.center - o;
  return SphereFrom(c, dot(c, c) - s.radius2);
}

// From the camera, whose power was worked out in f64.
SphereFrom sphereFromCamera(Sphere s) {
  return SphereFrom(s.center, s.power);
}

// How far along the ray the centre is nearest (x), and the square of half the chord that the ray cuts out (y).
vec2 sphereChord(Sphere s, SphereFrom from, vec3 d) {
  float b = dot(from.c, d);
  vec3 aside = from.c - b * d;
  return vec2(b, s.radius2 - dot(aside, aside));
}
#endif

#if defined(THROUGH)
#include "shape/sphere-through.glsl"
#elif defined(INSIDE)
#include "shape/sphere-inside.glsl"
#else
// The distance to the sphere, or MISS. A ray that leaves the sphere itself (own = 1) has the centre behind it, and does
// not meet it again.
float sphereDistance(Sphere s, SphereFrom from, vec3 d, float own) {
  vec2 chord = sphereChord(s, from, d);
  // No number where the ray passes by. What `mix` does not select has no effect (GLSL ES 3.00, section 8.3).
  float root = sqrt(chord.y);
  return mix(MISS, from.power / (chord.x + root), min(chord.x, chord.y) > 0.0);
}

#ifdef SHADOWS
// Above 0 where the sphere stands between its outside point and one `limit` away, which is outside too.
float sphereOcclusion(Sphere s, SphereFrom from, vec3 d, float limit, float own) {
  vec2 chord = sphereChord(s, from, d);
  return min(min(chord.x, limit - chord.x), chord.y);
}
#endif
#endif

#ifndef THROUGH
// The unit normal at a point of the sphere on the side that the ray came from, from what that point shares, times a
// weight.
vec3 sphereNormal(Sphere s, SphereFrom from, vec3 d, float weight) {
#ifdef WIDE_RANGE
  return (weight * sphereCurvature(s, from)) * from.c;
#else
  return (weight * s.curvature) * from.c;
#endif
}
#endif

#ifdef SPHERE_CHECKER
#include "shape/sphere-cells.glsl"
#endif
