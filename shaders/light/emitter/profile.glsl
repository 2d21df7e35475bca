// How much of a spotlight's light goes in a unit direction, between 0 and 1: linear in the angle from its axis.
// Precision: f32; the angle by `arcTangent`, which unlike an arc cosine keeps its digits near the axis.
#include "arc-tangent.glsl"

float profileAlong(Emitter e, vec3 direction) {
  vec3 aside = cross(e.aim, direction);
  float angle = arcTangent(sqrt(dotInOrder(aside, aside)), dotInOrder(e.aim, direction));
  return clamp((e.outer - angle) * e.perPenumbra, 0.0, 1.0);
}
