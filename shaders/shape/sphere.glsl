// Ray against sphere without cancellation, for unit directions and points relative to the camera, all in f32.
// Source: E. Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7 (2019): the
// discriminant from the part of the centre perpendicular to the ray, or b² - power where an exact power tells more; the
// roots without subtraction. There are no branches: a driver may run both sides of one anyway.

#ifdef SPHERE_CHECKER
#include "arc-tangent.glsl"
#endif
#ifdef WIDE_RANGE
#include "split-dot.glsl"
#endif

// What all rays from a point share: the way to the centre, and the power |c|² - r² of the point. It is exact where it was
// not worked out here, as a difference of squares in f32.
struct SphereFrom {
  vec3 c;
  float power;
  bool exact;
#ifdef WIDE_RANGE
  vec3 o;
#endif
};

SphereFrom sphereFrom(Sphere s, vec3 o) {
#ifdef WIDE_RANGE
  vec3 c = (s.center - o) + s.centerLow;
  float power = dot(c, c) - s.radius2;
  // Near the camera, what the power changes by on the way there: on a planet, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * s.radius2;
  return SphereFrom(c, mix(power, s.power - dot(o, s.center + c), near), near, o);
#else
  vec3 c = s.center - o;
  float power = dot(c, c) - s.radius2;
  return SphereFrom(c, power, false);
#endif
}

// From the camera, whose power was worked out in f64: next to a planet's surface, f32 would have none of it right.
SphereFrom sphereFromCamera(Sphere s) {
#ifdef WIDE_RANGE
  return SphereFrom(s.center, s.power, true, vec3(0.0));
#else
  return SphereFrom(s.center, s.power, true);
#endif
}

// How far along the ray the centre is nearest (x), and the square of half the chord that the ray cuts out (y).
vec2 sphereChord(Sphere s, SphereFrom from, vec3 d) {
#ifdef WIDE_RANGE
  // Near the camera c·d is what is left of a planet's radius, and b² - power what is left of that at the horizon: there
  // the first is worked out to twice the precision, and d is as long as it is.
  float a = dotInOrder(d, d);
  float split = 2.0 * splitDot(s.half1, s.half2, s.half3, d) - dotInOrder(from.o, d);
  float b = mix(dot(from.c, d), split, from.exact);
  vec3 aside = from.c - (b / a) * d;
  float b2 = b * b;
  float r2 = a * s.radius2;
  return vec2(b, mix(r2 - a * dot(aside, aside), b2 - a * from.power, from.exact && b2 < r2));
#else
  float b = dot(from.c, d);
  vec3 aside = from.c - b * d;
  float b2 = b * b;
  return vec2(b, mix(s.radius2 - dot(aside, aside), b2 - from.power, from.exact && b2 < s.radius2));
#endif
}

#ifdef THROUGH
#include "shape/sphere-through.glsl"
#else
// The distance to the sphere, or MISS. A ray that leaves the sphere itself (own = 1) for the outside has the centre
// behind it, and does not meet it again; from inside, its own root t = 0 is divided out and the other one is left.
float sphereDistance(Sphere s, SphereFrom from, vec3 d, float own) {
  vec2 chord = sphereChord(s, from, d);
#ifdef INSIDE
  chord.y = max(chord.y, 0.0);
#endif
  // No number where the ray passes by. What `mix` does not select has no effect (GLSL ES 3.00, section 8.3).
  float root = sqrt(chord.y);
  float t = mix(MISS, from.power / (chord.x + root), min(chord.x, chord.y) > 0.0);
#ifdef INSIDE
  float through = chord.x + root;
  float back = mix(-from.power / (root - chord.x), MISS, own > 0.5);
  t = mix(t, mix(back, through, chord.x > 0.0), s.curvature > 0.0);
#endif
  return t;
}
#endif

#if defined(SHADOWS) && !defined(THROUGH)
// Above 0 where the sphere stands between its outside point and one `limit` away, which is outside too.
float sphereOcclusion(Sphere s, SphereFrom from, vec3 d, float limit, float own) {
  vec2 chord = sphereChord(s, from, d);
  float blocked = min(min(chord.x, limit - chord.x), chord.y);
#ifdef INSIDE
  blocked = min(blocked, -s.curvature);
#endif
  return blocked;
}
#endif

// The unit normal at a point of the sphere on the side that the ray came from, from what that point shares, times a
// weight.
vec3 sphereNormal(Sphere s, SphereFrom from, vec3 d, float weight) {
#ifdef THROUGH
  // Outwards where the centre is ahead.
  float side = dot(from.c, d) > 0.0 ? -1.0 : 1.0;
#elif defined(WIDE_RANGE)
  float side = sign(s.curvature);
#endif
#ifdef WIDE_RANGE
  // The point may not be quite on the sphere.
  return (side * weight / sqrt(max(dot(from.c, from.c), SMALLEST))) * from.c;
#elif defined(THROUGH)
  return (side * weight * abs(s.curvature)) * from.c;
#else
  return (weight * s.curvature) * from.c;
#endif
}

#ifdef SIDES
// Whether the ray comes from outside: the centre is ahead.
bool sphereFront(Sphere s, SphereFrom from, vec3 d) {
  return dot(from.c, d) > 0.0;
}
#endif

#ifdef SPHERE_CHECKER
// The surface lengths (U, V), counted in cells: arcs from the meridian of +z towards +x, and from the pole at +y down.
vec2 sphereCells(Sphere s, vec3 p) {
  vec3 q = p - s.center;
  float fromAxis = sqrt(q.x * q.x + q.z * q.z);
  return s.cells * vec2(arcTangent(q.x, q.z), arcTangent(fromAxis, q.y));
}
#endif
