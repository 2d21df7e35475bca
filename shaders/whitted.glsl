// Integrator `direct` where light is more than points, or goes through surfaces: T. Whitted, "An Improved Illumination Model
// for Shaded Display", CACM 23(6), 1980. As direct.glsl: the light of all lights, then on in the one mirror direction or
// the refracted one, whatever the roughness. Of the two directions behind glass one is followed, by chance. Precision: f32.

#if defined(ENVIRONMENT) && defined(OPAQUE_BASE)
vec3 diffuseAlbedo(Bsdf bsdf, float cosine) {
#ifdef REFLECTIVE
  return splitAt(bsdf, cosine).diffuse;
#else
  return bsdf.color;
#endif
}
#endif

// The light of all lights, and of the surroundings by the diffuse part alone, without shadows.
vec3 lightOfAll(Parts scene, From from, vec3 p, vec3 n, mat3 frame, Bsdf bsdf, vec3 wo, vec2 u) {
  vec3 light = vec3(0.0);
#ifdef SHADOWS
  for (int i = 0; i < EMITTERS; i++) {
    EmitterSample one = sampleOf(emitters[i], p, u, isObject(emitters[i], from.own.object));
    light += lightBy(one, scene, from, frame, bsdf, wo);
  }
#endif
#if defined(ENVIRONMENT) && defined(OPAQUE_BASE)
  light += diffuseAlbedo(bsdf, wo.z) * environmentIrradiance(scene.surroundings, n);
#endif
  return light;
}

// On as from a smooth surface. The pdf tells whether lights could be asked for what is there.
BsdfSample mirrorSample(Bsdf bsdf, vec3 wo, float chance) {
#ifdef REFLECTIVE
  float facets = facetProbability(bsdf, wo.z);
  if (facets == 0.0) return BsdfSample(wo, vec3(0.0), 0.0);
#ifdef ROUGH
  float rough = step(SMALLEST, bsdf.alpha);
  bsdf.alpha = 0.0;
#else
  float rough = 0.0;
#endif
  BsdfSample onward = bsdfSample(bsdf, wo, vec2(0.5), chance * facets);
  return BsdfSample(onward.wi, facets * onward.weight, rough);
#else
  return BsdfSample(wo, vec3(0.0), 0.0);
#endif
}
