// The light that point and directional lights send to the eye by way of a surface. The 1 / pi of every BRDF is already
// in the packed intensities.

// BRDF times pi times the cosine, or 0 where the light is behind the surface. l: unit vector to the light.
vec3 scattered(Surface s, vec3 l, vec3 d) {
  float nl = max(dot(s.normal, l), 0.0);
#ifdef HIGHLIGHTS
  vec3 h = l - d;
  float weight = schlickWeight(0.5 * sqrt(dot(h, h)));
  Reflectance reflected = fresnel(s.material, weight) * ggxLobe(s.material.alpha2, s.normal, h, nl, s.nv);
#ifdef DIELECTRIC
  return nl * (diffuseAlbedo(s.material, weight) + reflected);
#else
  return nl * reflected;
#endif
#else
  return nl * s.material.color;
#endif
}

#ifdef POINT_LIGHTS
vec3 pointLight(PointLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 l = light.position - p;
  float distance2 = dot(l, l);
  float distance = sqrt(distance2);
  l /= distance;
  vec3 arriving = light.intensity;
#if defined(MIXED_FALLOFF)
  arriving /= mix(1.0, distance2, light.decays);
#elif defined(FALLOFF)
  arriving /= distance2;
#endif
#ifdef SHADOWS
  arriving *= step(occlusion(scene, from, l, distance), 0.0);
#endif
  return arriving * scattered(s, l, d);
}
#endif

#ifdef DIRECTIONAL_LIGHTS
vec3 directionalLight(DirectionalLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 arriving = light.irradiance;
#ifdef SHADOWS
  arriving *= step(occlusion(scene, from, light.toLight, MISS), 0.0);
#endif
  return arriving * scattered(s, light.toLight, d);
}
#endif
