// A sphere: from outside all directions that meet it are equally likely, from inside all directions are, and from a point on
// it all other points.
// Source: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996.
// Precision: f32; 1 - cos of the half-angle is taken from its sine.
#include "light/emitter/cone.glsl"
#include "light/emitter/placed.glsl"
#ifdef INNER_EMITTER
#include "light/emitter/inside.glsl"
#endif
#ifdef AIMED_BALL
#include "light/emitter/profile.glsl"
#endif

// How far away the centre is (x), and the power of the point (y): that squared less the radius squared.
vec2 sphereSeen(Emitter e, vec3 c) {
  float away = sqrt(dotInOrder(c, c));
  return vec2(away, (away - e.radius) * (away + e.radius));
}

// 1 - cos of the half-angle under which the sphere is seen from outside: sin² / (1 + cos), which does not cancel.
float sphereCone(Emitter e, vec2 seen) {
  float sine = e.radius / seen.x;
  return sine * sine / (1.0 + sqrt(seen.y) / seen.x);
}

// The way along d to where the centre is nearest (x), and half the chord that the line cuts out (y).
vec2 sphereCut(Emitter e, vec3 c, vec3 d) {
  float along = dotInOrder(c, d);
  vec3 aside = c - along * d;
  return vec2(along, sqrt(max(e.radius * e.radius - dotInOrder(aside, aside), 0.0)));
}

#ifdef INNER_EMITTER
// From a point on it, all points of a sphere are equally likely: that is in proportion to the cosine with the way to the
// centre, `axis`, as a dull surface scatters light, which then is gathered without noise.
EmitterSample acrossSample(Emitter e, vec3 axis, vec2 u) {
  vec3 way = axis + aroundDirection(u);
  float size = sqrt(dotInOrder(way, way));
  return insideSample(e, way / max(size, SMALLEST), e.radius * size, 0.5 * INVERSE_PI * size);
}
#endif

EmitterSample sphereSample(Emitter e, vec3 p, vec2 u, bool own) {
  vec3 c = wayTo(e, p);
  vec2 seen = sphereSeen(e, c);
  if (own || !(seen.y > 0.0)) {
#ifdef INNER_EMITTER
    if (own) return acrossSample(e, c / max(seen.x, SMALLEST), u);
    vec3 around = aroundDirection(u);
    vec2 cut = sphereCut(e, c, around);
    float exit = cut.x > 0.0 ? cut.x + cut.y : -seen.y / max(cut.y - cut.x, SMALLEST);
    return insideSample(e, around, exit, AROUND_PDF);
#else
    return NO_LIGHT;
#endif
  }
  float cone = sphereCone(e, seen);
  vec3 d = coneDirection(c / seen.x, cone, u);
  vec2 cut = sphereCut(e, c, d);
  vec3 radiance = e.side < 0.0 ? vec3(0.0) : e.strength;
#ifdef AIMED_BALL
  radiance *= profileAlong(e, -d);
#endif
  return EmitterSample(d, seen.y / max(cut.x + cut.y, SMALLEST), radiance, conePdf(cone), false, e.object);
}

float spherePdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  vec3 c = wayTo(e, from);
  vec2 seen = sphereSeen(e, c);
#ifdef INNER_EMITTER
  if (own) return e.side > 0.0 ? 0.0 : INVERSE_PI * max(dotInOrder(c, d), 0.0) / max(seen.x, SMALLEST);
  if (!(seen.y > 0.0)) return insidePdf(e);
#else
  if (own || !(seen.y > 0.0)) return 0.0;
#endif
  return conePdf(sphereCone(e, seen));
}
