// What becomes of light at a facet of a material: glTF 2.0 metallic-roughness, its definition by `mix` (Appendix B of the
// specification), KHR_materials_ior, _specular and _transmission. Precision: f32.
#ifdef TRANSMISSION
#include "material/dielectric.glsl"
#endif

// A material at one point.
struct Bsdf {
  vec3 color;
#if defined(METAL) && defined(DIELECTRIC)
  float metalness;
#endif
#ifdef ROUGH
  // GGX; 0 is a mirror.
  float alpha;
#endif
#if defined(SPECULAR) && defined(OPAQUE_BASE)
  // Reflectance of the dielectric layer straight on and at grazing angles, for Schlick's approximation.
  vec3 f0;
#ifdef SPECULAR_WEIGHT
  float f90;
#endif
#endif
#ifdef TRANSMISSION
  // Index of refraction behind the surface over that in front; of a thin wall, of what it is made of.
  float eta;
#ifdef OPAQUE_BASE
  float transmission;
#endif
#if defined(SPECULAR_TINT) || defined(SPECULAR_WEIGHT)
  // Factor on the exact Fresnel reflectance.
  vec3 specular;
#endif
#if defined(THIN) && defined(SOLID)
  // Whether the surface is a wall with the same on both sides.
  bool thin;
#endif
#endif
};

#if defined(OPAQUE_BASE) && defined(SMOOTH)
// Whether some light is scattered below the surface.
bool hasBase(Bsdf b) {
  float share = 1.0;
#ifdef METAL
  share *= 1.0 - b.metalness;
#endif
#ifdef TRANSMISSION
  share *= 1.0 - b.transmission;
#endif
  return share > 0.0;
}
#endif

#ifdef REFLECTIVE
// What becomes of light at a facet.
struct Split {
  vec3 reflected;
#ifdef OPAQUE_BASE
  // Is scattered below the surface and comes out of it again.
  vec3 diffuse;
#endif
#ifdef TRANSMISSION
  // Goes on behind the surface.
  vec3 transmitted;
#endif
  // Probability that a facet reflects rather than lets through.
  float reflection;
};

float sum(vec3 color) {
  return color.r + color.g + color.b;
}

float largest(vec3 color) {
  return max(max(color.r, color.g), color.b);
}

#if defined(METAL) || defined(SPECULAR) && defined(OPAQUE_BASE)
// (1 - cos)^5, the weight of Schlick's approximation.
float schlickWeight(float cosine) {
  // Rounding may carry a cosine above 1.
  float m = max(1.0 - cosine, 0.0);
  float m2 = m * m;
  return m2 * m2 * m;
}
#endif

#ifdef SPECULAR
// Reflectance of the dielectric layer.
vec3 layerReflectance(Bsdf b, float cosine) {
#ifdef TRANSMISSION
#ifdef OPAQUE_BASE
  if (b.transmission > 0.0)
#endif
#if defined(SPECULAR_TINT) || defined(SPECULAR_WEIGHT)
    return b.specular * exactFresnel(cosine, b.eta);
#else
    return vec3(exactFresnel(cosine, b.eta));
#endif
#endif
#ifdef OPAQUE_BASE
#ifdef SPECULAR_WEIGHT
  return b.f0 + (b.f90 - b.f0) * schlickWeight(cosine);
#else
  return b.f0 + (1.0 - b.f0) * schlickWeight(cosine);
#endif
#endif
}
#endif

// At a facet whose normal makes the given cosine with wo.
Split splitAt(Bsdf b, float cosine) {
  Split s;
#ifdef DIELECTRIC
  float under = 1.0;
#ifdef SPECULAR
  s.reflected = layerReflectance(b, cosine);
  under -= largest(s.reflected);
#else
  s.reflected = vec3(0.0);
#endif
#ifdef METAL
  vec3 metal = b.color + (1.0 - b.color) * schlickWeight(cosine);
  s.reflected = s.reflected * (1.0 - b.metalness) + metal * b.metalness;
  under *= 1.0 - b.metalness;
#endif
#else
  s.reflected = b.color + (1.0 - b.color) * schlickWeight(cosine);
#endif
#ifdef TRANSMISSION
  float through = under;
#ifdef OPAQUE_BASE
  through *= b.transmission;
  s.diffuse = b.color * (under * (1.0 - b.transmission));
#endif
#if defined(SOLID) && defined(THIN)
  if (!b.thin && refractedCosine2(cosine, b.eta) < 0.0) through = 0.0;
#elif defined(SOLID)
  if (refractedCosine2(cosine, b.eta) < 0.0) through = 0.0;
#endif
  s.transmitted = b.color * through;
  float all = sum(s.reflected) + sum(s.transmitted);
  s.reflection = all > 0.0 ? sum(s.reflected) / all : 1.0;
#else
  s.reflection = 1.0;
#ifdef OPAQUE_BASE
  s.diffuse = b.color * under;
#endif
#endif
  return s;
}

#ifdef OPAQUE_BASE
// What is scattered below the surface, from wi to wo. glTF has it lose by the half vector alone, and so gives back more
// than arrives where the layer reflects much and facets turned to the light do not: inside of what is partly let through,
// where total reflection keeps light, without bounds. There it loses by the angles of both directions too.
vec3 diffuseBetween(Bsdf b, Split s, vec3 wo, vec3 wi) {
#ifdef TRANSMISSION
  if (b.transmission > 0.0) return min(s.diffuse, min(splitAt(b, wo.z).diffuse, splitAt(b, wi.z).diffuse));
#endif
  return s.diffuse;
}
#endif

// Probability of not drawing from the diffuse lobe, which is drawn from in proportion to the albedos of the lobes. What
// gets under an opaque layer is taken straight on there, since light that is scattered diffusely meets facets that are
// turned towards it.
float facetProbability(Bsdf b, float cosine) {
#ifdef OPAQUE_BASE
  Split s = splitAt(b, cosine);
  float diffuse = sum(b.color);
#ifdef METAL
  diffuse *= 1.0 - b.metalness;
#endif
#ifdef SPECULAR
  diffuse *= 1.0 - largest(b.f0);
#endif
  float facets = sum(s.reflected);
#ifdef TRANSMISSION
  if (b.transmission > 0.0) diffuse = sum(s.diffuse);
  facets += sum(s.transmitted);
#endif
  return diffuse > 0.0 ? facets / (diffuse + facets) : 1.0;
#else
  return 1.0;
#endif
}
#endif
