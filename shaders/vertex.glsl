// What a surface does to light, where a path meets it: its material with the index of refraction of what is on its sides.
// Precision: f32.

Bsdf bsdfAt(Material m, float eta, bool closed) {
  Bsdf b;
  b.color = m.color;
#if defined(METAL) && defined(DIELECTRIC)
  b.metalness = m.metalness;
#endif
#ifdef ROUGH
  b.alpha = m.alpha;
#endif
#if defined(SPECULAR) && defined(OPAQUE_BASE)
  b.f0 = vec3(m.f0);
#ifdef SPECULAR_WEIGHT
  b.f90 = m.f90;
#endif
#endif
#ifdef TRANSMISSION
  b.eta = eta;
#ifdef OPAQUE_BASE
  b.transmission = m.transmission;
#endif
#if defined(SPECULAR_TINT) || defined(SPECULAR_WEIGHT)
  b.specular = m.specular;
#endif
#if defined(THIN) && defined(SOLID)
  b.thin = !closed;
#endif
#endif
  return b;
}

#ifdef SOLID
// Index of refraction behind the surface over that in front. Within another medium entered later, there is no surface.
float relativeIndex(float ior, Media media, int object, bool front) {
  if (front) return ior / mediumIndex(media);
#ifdef NESTED
  return mediumIndex(leave(media, object)) / mediumIndex(media);
#else
  return 1.0 / ior;
#endif
}
#endif
