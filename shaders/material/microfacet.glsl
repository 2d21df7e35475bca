// GGX, in the frame of the surface, whose normal is z. alpha is 2^-32 or more, so that no power of it leaves the range of
// f32. Precision: f32; 1 - cos² is always taken from x and y, so that nothing cancels however narrow the lobe is.
#ifdef ROUGH
#include "circle.glsl"
#include "constants.glsl"
#endif

// A normal of the microsurface that is seen from a direction wo; its cosine with wo, and D at it.
struct Facet {
  vec3 normal;
  float cosine;
  float density;
};

float squared(vec3 v) {
  return v.x * v.x + v.y * v.y + v.z * v.z;
}

#ifdef ROUGH
// D, for a half vector of any length with h.z > 0.
float ggx(float alpha, vec3 h) {
  float root = alpha * squared(h) / max(squared(vec3(h.xy, alpha * h.z)), SMALLEST);
  return root * root * INVERSE_PI;
}

// G1 of Smith over the cosine, for a cosine in [0, 1]: a number at 0 too.
float smithOverCosine(float alpha, float cosine) {
  return 2.0 / max(cosine + sqrt(alpha * alpha + (1.0 - alpha * alpha) * (cosine * cosine)), SMALLEST);
}

// A visible normal, with the probability density G1(wo) D(h) (wo·h) / wo.z.
// Source: J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", Computer Graphics Forum 42(8), 2023.
Facet visibleNormal(float alpha, vec3 wo, vec2 u) {
  // Stretched along z so that the microsurface is a hemisphere.
  vec3 v = vec3(alpha * wo.xy, wo.z);
  float size = sqrt(squared(v));
  v /= max(size, SMALLEST);
  // What is mirrored by a hemisphere goes evenly to the cap -v.z < z <= 1. Written by what adds up, not by what cancels.
  float cap = 1.0 + v.z;
  float height = cap * (1.0 - u.y);
  float radius = sqrt(u.y * (cap * height + v.x * v.x + v.y * v.y));
  vec3 h = vec3(radius * circle(u.x) + v.xy, height);
  vec3 unstretched = vec3(alpha * h.xy, h.z);
  float stretched2 = squared(h);
  float length2 = max(squared(unstretched), SMALLEST);
  float root = length2 / max(alpha * stretched2, SMALLEST);
  float inverse = 1.0 / sqrt(length2);
  // v·h is half of h·h, since h is the sum of v and of what v is mirrored to.
  return Facet(unstretched * inverse, min(0.5 * size * stretched2 * inverse, 1.0), root * root * INVERSE_PI);
}
#endif
