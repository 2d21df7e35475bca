// The material that a probe asks about.
#include "material/bsdf.glsl"

uniform vec3 color;
uniform float metalness, alpha, f90, eta, transmission, thin;
uniform vec3 f0, specular;

Bsdf material() {
  Bsdf b;
  b.color = color;
#if defined(METAL) && defined(DIELECTRIC)
  b.metalness = metalness;
#endif
#ifdef ROUGH
  b.alpha = alpha;
#endif
#if defined(SPECULAR) && defined(OPAQUE_BASE)
  b.f0 = f0;
#ifdef SPECULAR_WEIGHT
  b.f90 = f90;
#endif
#endif
#ifdef TRANSMISSION
  b.eta = eta;
#ifdef OPAQUE_BASE
  b.transmission = transmission;
#endif
#if defined(SPECULAR_TINT) || defined(SPECULAR_WEIGHT)
  b.specular = specular;
#endif
#if defined(THIN) && defined(SOLID)
  b.thin = thin > 0.0;
#endif
#endif
  return b;
}
