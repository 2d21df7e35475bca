// How a material scatters light at one point: the microfacets of glTF 2.0 with the separable Smith term, over a diffuse
// base. What is let through goes by B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007;
// behind thin walls it is the reflected lobe turned over. Directions have unit length and are in the frame of the surface:
// z is the normal on the side of wo, wo goes to the eye, wi to where the light comes from. Precision: f32; narrow lobes
// are told by the facet that was drawn, since rounded directions do not tell them.
#include "constants.glsl"
#include "material/fresnel.glsl"
#ifdef OPAQUE_BASE
#include "circle.glsl"
#endif
#ifdef REFLECTIVE
#include "material/microfacet.glsl"
#endif

struct BsdfSample {
  vec3 wi;
  // f |cos| / pdf; 0 where the path ends.
  vec3 weight;
  // Per solid angle; 0 for a direction that no other could have been.
  float pdf;
};

#ifdef OPAQUE_BASE
// A direction whose probability density is its cosine over pi.
vec3 cosineDirection(vec2 u) {
  return vec3(sqrt(u.y) * circle(u.x), sqrt(1.0 - u.y));
}
#endif

#ifdef REFLECTIVE
// Both lobes above the surface; `facets` is the probability of not drawing from the diffuse one, `density` is D.
vec3 reflection(Bsdf b, vec3 wo, vec3 wi, float density, Split s, float facets, out float pdf) {
  vec3 value = vec3(0.0);
  pdf = 0.0;
#ifdef OPAQUE_BASE
  float even = INVERSE_PI * wi.z;
  value = even * diffuseBetween(b, s, wo, wi);
  pdf = even * (1.0 - facets);
#endif
#ifdef ROUGH
  float lobe = 0.25 * density * smithOverCosine(b.alpha, wo.z);
  value += (lobe * (wi.z * smithOverCosine(b.alpha, wi.z))) * s.reflected;
  pdf += facets * s.reflection * lobe;
#endif
  return value;
}

// The facet that mirrors wo to wi, told by their sum.
Facet halfway(Bsdf b, vec3 h) {
  float density = 0.0;
#ifdef ROUGH
  density = ggx(b.alpha, h);
#endif
  float size = sqrt(squared(h));
  return Facet(h / max(size, SMALLEST), 0.5 * size, density);
}

// A facet that is seen from wo.
Facet facetSeen(Bsdf b, vec3 wo, vec2 u) {
#ifdef SMOOTH
#ifdef ROUGH
  if (b.alpha == 0.0)
#endif
    return Facet(vec3(0.0, 0.0, 1.0), wo.z, 0.0);
#endif
#ifdef ROUGH
  return visibleNormal(b.alpha, wo, u);
#endif
}

vec3 mirrored(vec3 wo, Facet facet) {
  return 2.0 * facet.cosine * facet.normal - wo;
}
#endif

#ifdef THIN
#ifdef ROUGH
// The lobe below a thin wall: that of reflection, turned over.
vec3 throughWall(Bsdf b, vec3 wo, vec3 wi, out float pdf) {
  Facet facet = halfway(b, vec3(wo.xy + wi.xy, wo.z - wi.z));
  Split s = splitAt(b, facet.cosine);
  float lobe = 0.25 * facet.density * smithOverCosine(b.alpha, wo.z);
  pdf = facetProbability(b, wo.z) * (1.0 - s.reflection) * lobe;
  return (lobe * (-wi.z * smithOverCosine(b.alpha, -wi.z))) * s.transmitted;
}
#endif

// `probability` is that of coming here.
BsdfSample sampleWall(Bsdf b, vec3 wo, Facet facet, Split s, float probability) {
  vec3 wi = mirrored(wo, facet);
  wi.z = -wi.z;
  vec3 weight = s.transmitted / max(probability, SMALLEST);
#ifdef SMOOTH
#ifdef ROUGH
  if (b.alpha == 0.0)
#endif
    return BsdfSample(wi, weight, 0.0);
#endif
#ifdef ROUGH
  if (wi.z >= 0.0) return BsdfSample(wi, vec3(0.0), 0.0);
  float visible = facet.density * smithOverCosine(b.alpha, wo.z);
  return BsdfSample(wi, weight * (-wi.z * smithOverCosine(b.alpha, -wi.z)), probability * 0.25 * visible);
#endif
}
#endif

#ifdef SOLID
#ifdef ROUGH
// The lobe below a rough surface, equations 16, 17 and 21 of Walter et al. With the half vector h = wo + eta wi not
// normalised and the products taken from wo + wi, nothing cancels where eta is near 1.
vec3 refraction(Bsdf b, vec3 wo, vec3 wi, out float pdf) {
  pdf = 0.0;
  vec3 both = wo + wi;
  float side = b.eta > 1.0 ? -1.0 : 1.0;
  vec3 h = side * (both + (b.eta - 1.0) * wi);
  float half2 = 0.5 * squared(both);
  float woH = side * (1.0 - b.eta + b.eta * half2);
  float wiH = -side * (b.eta - 1.0 + half2);
  if (b.eta == 1.0 || !(h.z > 0.0 && woH > 0.0 && wiH > 0.0)) return vec3(0.0);
  float length2 = max(squared(h), SMALLEST);
  Split s = splitAt(b, min(woH / sqrt(length2), 1.0));
  float lobe = ggx(b.alpha, h) * smithOverCosine(b.alpha, wo.z) * (woH / length2) * (wiH / length2);
  lobe = min(lobe, LARGEST);
  pdf = facetProbability(b, wo.z) * (1.0 - s.reflection) * (b.eta * b.eta) * lobe;
  return (lobe * (-wi.z * smithOverCosine(b.alpha, -wi.z))) * s.transmitted;
}

// Solid angle of facets over that of the directions that they refract to: equation 17 of Walter et al.
float refractedDensity(float cosine, float eta) {
  float behind = sqrt(max(refractedCosine2(cosine, eta), 0.0));
  float difference = (eta - 1.0) * (eta + 1.0) / max(cosine + behind, SMALLEST);
  return eta * behind / max(difference * difference, SMALLEST);
}
#endif

// `probability` is that of coming here.
BsdfSample sampleRefraction(Bsdf b, vec3 wo, Facet facet, Split s, float probability) {
  vec3 weight = s.transmitted / max(probability * b.eta * b.eta, SMALLEST);
  // With the same on both sides there is nothing that could bend it, nor anything rough.
  if (b.eta == 1.0) return BsdfSample(-wo, weight, 0.0);
  vec3 wi = refracted(wo, facet.normal, facet.cosine, b.eta);
#ifdef SMOOTH
#ifdef ROUGH
  if (b.alpha == 0.0)
#endif
    return BsdfSample(wi, weight, 0.0);
#endif
#ifdef ROUGH
  if (wi.z >= 0.0) return BsdfSample(wi, vec3(0.0), 0.0);
  float visible = facet.density * smithOverCosine(b.alpha, wo.z) * facet.cosine;
  float pdf = probability * min(visible * refractedDensity(facet.cosine, b.eta), LARGEST);
  return BsdfSample(wi, weight * (-wi.z * smithOverCosine(b.alpha, -wi.z)), pdf);
#endif
}
#endif

// Whether there is nothing that lights could be asked for.
bool isMirrorOnly(Bsdf b) {
#ifdef SMOOTH
  bool isMirror = true;
#ifdef ROUGH
  isMirror = b.alpha == 0.0;
#endif
#ifdef OPAQUE_BASE
  isMirror = isMirror && !hasBase(b);
#endif
  return isMirror;
#else
  return false;
#endif
}

// What light from wi gives in the direction wo, f |cos|, and the density with which `bsdfSample` finds wi. What only
// mirrors do is left out.
vec3 bsdfValue(Bsdf b, vec3 wo, vec3 wi, out float pdf) {
  pdf = 0.0;
#if defined(OPAQUE_BASE) && !defined(REFLECTIVE)
  pdf = INVERSE_PI * max(wi.z, 0.0);
  return pdf * b.color;
#else
#if defined(OPAQUE_BASE) || defined(ROUGH)
  if (wi.z > 0.0) {
    Facet facet = halfway(b, wo + wi);
    return reflection(b, wo, wi, facet.density, splitAt(b, facet.cosine), facetProbability(b, wo.z), pdf);
  }
#endif
#if defined(ROUGH) && defined(TRANSMISSION)
#ifdef OPAQUE_BASE
  if (b.transmission == 0.0) return vec3(0.0);
#endif
  if (wi.z == 0.0) return vec3(0.0);
#ifdef THIN
#ifdef SOLID
  if (b.thin)
#endif
    return throughWall(b, wo, wi, pdf);
#endif
#ifdef SOLID
  return refraction(b, wo, wi, pdf);
#endif
#endif
  return vec3(0.0);
#endif
}

// Draws wi. u is where on the lobe; `lobe` in [0, 1) tells which: a facet, which reflects or lets through, or the base.
BsdfSample bsdfSample(Bsdf b, vec3 wo, vec2 u, float lobe) {
#ifdef REFLECTIVE
  float facets = facetProbability(b, wo.z);
  Facet facet = facetSeen(b, wo, u);
  vec3 wi = mirrored(wo, facet);
#ifdef OPAQUE_BASE
  if (lobe >= facets) {
    wi = cosineDirection(u);
    facet = halfway(b, wo + wi);
  }
#endif
  Split s = splitAt(b, facet.cosine);
#ifdef TRANSMISSION
  if (lobe >= facets * s.reflection && lobe < facets) {
    float probability = facets * (1.0 - s.reflection);
#ifdef THIN
#ifdef SOLID
    if (b.thin)
#endif
      return sampleWall(b, wo, facet, s, probability);
#endif
#ifdef SOLID
    return sampleRefraction(b, wo, facet, s, probability);
#endif
  }
#endif
  if (lobe < facets) {
#if defined(SMOOTH) && defined(ROUGH)
    if (b.alpha == 0.0) return BsdfSample(wi, s.reflected / (facets * s.reflection), 0.0);
#elif defined(SMOOTH)
    return BsdfSample(wi, s.reflected / (facets * s.reflection), 0.0);
#endif
    if (!(wi.z > 0.0 && sum(s.reflected) > 0.0)) return BsdfSample(wi, vec3(0.0), 0.0);
  }
#if defined(ROUGH) || defined(OPAQUE_BASE)
  float pdf;
  vec3 value = reflection(b, wo, wi, facet.density, s, facets, pdf);
  return BsdfSample(wi, value / pdf, pdf);
#endif
#elif defined(OPAQUE_BASE)
  return BsdfSample(cosineDirection(u), b.color, INVERSE_PI * sqrt(1.0 - u.y));
#else
  // A scene without any material.
  return BsdfSample(wo, vec3(0.0), 0.0);
#endif
}
