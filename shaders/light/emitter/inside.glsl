// A closed surface around a point, in all directions equally likely. Precision: f32.
#include "circle.glsl"

const float AROUND_PDF = 0.0795774715;

// A unit vector. The smaller of u and 1 - u is the factor, so that u - u², which a compiler may make of it, cancels nothing.
vec3 aroundDirection(vec2 u) {
  float fromPole = min(u.x, 1.0 - u.x);
  return vec3(2.0 * sqrt(fromPole * (1.0 - fromPole)) * circle(u.y), 1.0 - 2.0 * u.x);
}

// The light from the inner side of a surface that is `distance` away; from a point on it, some directions lead outside.
EmitterSample insideSample(Emitter e, vec3 d, float distance, float pdf) {
  if (e.side > 0.0) return NO_LIGHT;
  vec3 radiance = distance > 0.0 ? e.strength : vec3(0.0);
  return EmitterSample(d, max(distance, 0.0), radiance, pdf, false, e.object);
}

float insidePdf(Emitter e) {
  return e.side > 0.0 ? 0.0 : AROUND_PDF;
}
