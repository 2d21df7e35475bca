// A parallelogram: by solid angle where that is at least `leastAngle` (it never is where it is no rectangle), else by area.
// Precision: f32.
#include "circle.glsl"
#include "light/emitter/area.glsl"
#include "light/emitter/rectangle.glsl"

// In axes along the edges and the normal, around the point, in units of about the distance of its farthest corner.
Rectangle quadSeen(Emitter e, vec3 c, float height) {
  float wide = sqrt(dotInOrder(e.edgeU, e.edgeU));
  float tall = sqrt(dotInOrder(e.edgeV, e.edgeV));
  vec2 low = vec2(dotInOrder(c, e.edgeU) / max(wide, SMALLEST), dotInOrder(c, e.edgeV) / max(tall, SMALLEST));
  vec2 high = low + vec2(wide, tall);
  vec2 reach = max(abs(low), abs(high));
  float unit = 1.0 / max(max(reach.x, reach.y), max(abs(height), SMALLEST));
  return Rectangle(unit * low, unit * high, unit * abs(height));
}

EmitterSample quadSample(Emitter e, vec3 p, vec2 u, bool own) {
  if (own) return NO_LIGHT;
  vec3 c = wayTo(e, p);
  float height = dotInOrder(e.axis, c);
  Rectangle seen = quadSeen(e, c, height);
  float angle = rectangleAngle(seen);
  bool bySolidAngle = angle >= e.leastAngle;
  vec2 place = bySolidAngle ? rectanglePlace(seen, angle, u) : u;
  EmitterSample s = areaSample(e, c + place.x * e.edgeU + place.y * e.edgeV, abs(height), e.area, height < 0.0);
  if (bySolidAngle && s.pdf > 0.0) s.pdf = 1.0 / angle;
  return s;
}

float quadPdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  vec3 c = wayTo(e, from);
  float angle = rectangleAngle(quadSeen(e, c, dotInOrder(e.axis, c)));
  return angle >= e.leastAngle ? 1.0 / max(angle, SMALLEST) : areaPdf(t, cosine, e.area);
}
