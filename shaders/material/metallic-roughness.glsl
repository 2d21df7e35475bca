// glTF 2.0 metallic-roughness, its definition by `mix` (Appendix B of the specification), with KHR_materials_ior and
// KHR_materials_specular. GGX with the separable Smith term. Precision: f32; see `ggxLobe` for what would cancel.

// Without metals and tints, what is reflected is the same in all three channels.
#if defined(METAL) || defined(SPECULAR_TINT)
#define Reflectance vec3
#else
#define Reflectance float
#endif
#ifdef SPECULAR_TINT
#define DielectricReflectance vec3
#else
#define DielectricReflectance float
#endif

#ifdef REFLECTIVE
// (1 - cos)^5, the weight of Schlick's approximation.
float schlickWeight(float cosine) {
  // Rounding may carry a cosine above 1.
  float m = max(1.0 - cosine, 0.0);
  float m2 = m * m;
  return m2 * m2 * m;
}
#endif

#ifdef SPECULAR
// Fresnel reflectance of the dielectric layer.
DielectricReflectance dielectricFresnel(Material m, float weight) {
#ifdef SPECULAR_WEIGHT
  return m.f0 + (m.f90 - m.f0) * weight;
#else
  return m.f0 + (1.0 - m.f0) * weight;
#endif
}
#endif

#if defined(REFLECTIVE) && defined(DIELECTRIC)
// The share of the light that gets under the dielectric layer and comes out again in the base colour.
float diffuseShare(Material m, float weight) {
  float share = 1.0;
#if defined(SPECULAR_TINT)
  vec3 reflected = dielectricFresnel(m, weight);
  share -= max(max(reflected.r, reflected.g), reflected.b);
#elif defined(SPECULAR)
  share -= dielectricFresnel(m, weight);
#endif
#ifdef METAL
  share *= 1.0 - m.metalness;
#endif
  return share;
}
#endif

#ifdef REFLECTIVE
// Fresnel reflectance of the whole material: of its dielectric and its metal part, by metalness.
Reflectance fresnel(Material m, float weight) {
#ifdef METAL
  vec3 reflectance = m.color + (1.0 - m.color) * weight;
#ifdef DIELECTRIC
#ifdef SPECULAR
  reflectance = mix(vec3(dielectricFresnel(m, weight)), reflectance, m.metalness);
#else
  reflectance *= m.metalness;
#endif
#endif
  return reflectance;
#else
  return dielectricFresnel(m, weight);
#endif
}
#endif

#ifdef HIGHLIGHTS
// pi D V. With h = l + v not normalised and 1 - (n·h)² as |h - (n·h) n|², nothing cancels however narrow the lobe is.
float ggxLobe(float alpha2, vec3 n, vec3 h, float nl, float nv) {
  float along = nl + nv;
  vec3 across = h - along * n;
  float width = dot(across, across) + alpha2 * (along * along);
  float rest = 1.0 - alpha2;
  float smith = (nl + sqrt(alpha2 + rest * (nl * nl))) * (nv + sqrt(alpha2 + rest * (nv * nv)));
  float hh = dot(h, h);
  return alpha2 * (hh * hh) / max(width * width * smith, SMALLEST);
}
#endif
