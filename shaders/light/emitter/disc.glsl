// A disc, by area. Precision: f32.
#include "circle.glsl"
#include "tangents.glsl"
#include "light/emitter/area.glsl"

float discArea(Emitter e) {
  return 3.14159265359 * e.radius * e.radius;
}

EmitterSample discSample(Emitter e, vec3 p, vec2 u, bool own) {
  if (own) return NO_LIGHT;
  vec3 c = wayTo(e, p);
  float height = dotInOrder(e.axis, c);
  vec3 x;
  vec3 y;
  tangents(e.axis, x, y);
  vec2 place = e.radius * sqrt(u.x) * circle(u.y);
  return areaSample(e, c + (place.x * x + place.y * y), abs(height), discArea(e), height < 0.0);
}

float discPdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  return areaPdf(t, cosine, discArea(e));
}
