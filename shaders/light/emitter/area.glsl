// Points of a surface, all equally likely, as directions: the pdf is distance² / (cos area). Source: M. Pharr,
// W. Jakob, G. Humphreys, "Physically Based Rendering", 4th ed., section 4.2.3. Precision: f32; `height` in place of the cosine,
// since it can be told without cancelling.
#include "light/emitter/placed.glsl"
#include "light/emitter/shining.glsl"

// The light from the end of `way`. `height`: how far the point is from the plane of the surface there; it is on the front of
// it, or not; `area`: of all the surface that might have been chosen.
EmitterSample areaSample(Emitter e, vec3 way, float height, float area, bool front) {
  float distance2 = dotInOrder(way, way);
  if (!(height > 0.0 && distance2 > SMALLEST)) return NO_LIGHT;
  float distance = sqrt(distance2);
  float pdf = min(distance2 / max(height * area, SMALLEST), LARGEST) * distance;
  return EmitterSample(way / distance, distance, shines(e, front) * e.strength, pdf, false, e.object);
}

// The pdf of a direction that meets the surface at a distance, under an angle of this cosine with its normal.
float areaPdf(float t, float cosine, float area) {
  float facing = abs(cosine) * area;
  return facing > 0.0 ? min(t * t / max(facing, SMALLEST), LARGEST) : 0.0;
}
