// The same radiance from all directions of a cone. Precision: f32.
#include "light/emitter/cone.glsl"

EmitterSample sunSample(Emitter e, vec3 p, vec2 u, bool own) {
  return EmitterSample(coneDirection(e.axis, e.cone, u), MISS, e.strength, conePdf(e.cone), false, -1);
}

// 0 for directions that do not lead to it.
float sunPdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  vec3 aside = d - e.axis;
  // Of unit vectors, the square of their difference is 2 (1 - cos).
  return dotInOrder(aside, aside) <= 2.0 * e.cone ? conePdf(e.cone) : 0.0;
}
