// Light from a point into a cone. Precision: f32.
#include "light/emitter/point.glsl"
#include "light/emitter/profile.glsl"

EmitterSample spotSample(Emitter e, vec3 p, vec2 u, bool own) {
  EmitterSample s = pointSample(e, p, u, own);
  s.radiance *= profileAlong(e, -s.direction);
  return s;
}
