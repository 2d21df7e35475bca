// A triangle, by area: towards the side across from its first corner by the root of u.x, since it widens that way.
// Source: G. Turk, "Generating Random Points in Triangles", Graphics Gems (1990). Precision: f32.
#include "light/emitter/area.glsl"

EmitterSample triangleSample(Emitter e, vec3 p, vec2 u, bool own) {
  if (own) return NO_LIGHT;
  vec3 c = wayTo(e, p);
  float height = dotInOrder(e.axis, c);
  float root = sqrt(u.x);
  vec3 way = c + root * (1.0 - u.y) * e.edgeU + root * u.y * e.edgeV;
  return areaSample(e, way, abs(height), e.area, height < 0.0);
}

float trianglePdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  return areaPdf(t, cosine, e.area);
}
