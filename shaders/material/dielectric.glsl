// Smooth dielectrics: exact Fresnel reflectance and refraction. eta is the index of refraction behind the surface over that
// in front. Precision: f32; differences of cosines are written by their products, which are differences of indices.
#include "constants.glsl"

// (eta times the cosine of the refracted direction)², for a direction that makes the given cosine in [0, 1] with the
// normal; below 0, all of it is reflected.
float refractedCosine2(float cosine, float eta) {
  return (eta - 1.0) * (eta + 1.0) + cosine * cosine;
}

#ifdef SPECULAR
// Fresnel reflectance, unpolarised. In place of cos - eta cos' there is its product with cos + eta cos', which is
// 1 - eta²: nothing cancels, and where eta is 1 there is no reflection.
float exactFresnel(float cosine, float eta) {
  float behind2 = refractedCosine2(cosine, eta);
  if (behind2 < 0.0) return 1.0;
  float behind = sqrt(behind2);
  float sum = max(cosine + behind, SMALLEST);
  float difference = (eta - 1.0) * (eta + 1.0) / sum;
  float s = difference / sum;
  float p = difference * (cosine * sum - 1.0) / max(eta * eta * cosine + behind, SMALLEST);
  return min(0.5 * (s * s + p * p), 1.0);
}
#endif

#ifdef SOLID
// Where wo, which makes the cosine with h, goes behind the surface; both have unit length. There must be such a way.
vec3 refracted(vec3 wo, vec3 h, float cosine, float eta) {
  return ((wo - cosine * h) + sqrt(max(refractedCosine2(cosine, eta), 0.0)) * h) / -eta;
}
#endif
