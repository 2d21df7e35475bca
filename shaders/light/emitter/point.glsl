// Light from a point: intensity over the distance squared, unless it does not fade. Precision: f32.
#include "light/emitter/placed.glsl"

EmitterSample pointSample(Emitter e, vec3 p, vec2 u, bool own) {
  vec3 way = wayTo(e, p);
  float distance2 = dotInOrder(way, way);
  if (!(distance2 > SMALLEST)) return NO_LIGHT;
  float distance = sqrt(distance2);
#ifdef STEADY_EMITTER
  vec3 irradiance = e.strength / mix(1.0, distance2, e.decays);
#else
  vec3 irradiance = e.strength / distance2;
#endif
  return EmitterSample(way / distance, distance, min(irradiance, vec3(LARGEST)), 1.0, true, -1);
}
