// The light that point and directional lights send to the eye by way of a surface. The 1 / pi of every BRDF is already
// in the packed intensities.

// Without colour in it, light is the same in all three channels.
#ifdef COLORED_LIGHT
#define Light vec3
#else
#define Light float
#endif
#if defined(COLORED_LIGHT) || defined(METAL) || defined(SPECULAR_TINT)
#define Highlight vec3
#else
#define Highlight float
#endif

// What is to be multiplied by the base colour, and what leaves without having been under the surface.
struct Lit {
  Light diffuse;
  Highlight specular;
};

Lit both(Lit a, Lit b) {
  return Lit(a.diffuse + b.diffuse, a.specular + b.specular);
}

// Light that arrives along -l: BRDF times cosine, or 0 where the light is behind the surface.
Lit scattered(Light arriving, Surface s, vec3 l, vec3 d) {
  float nl = max(dot(s.normal, l), 0.0);
  Light received = nl * arriving;
#ifdef HIGHLIGHTS
  vec3 h = l - d;
  float weight = schlickWeight(0.5 * sqrt(dot(h, h)));
  float lobe = ggxLobe(s.material.alpha2, s.normal, h, nl, s.nv);
  return Lit(received * diffuseShare(s.material, weight), received * lobe * fresnel(s.material, weight));
#else
  return Lit(received, Highlight(0.0));
#endif
}

#ifdef POINT_LIGHTS
Lit pointLight(PointLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 l = light.position - p;
  float distance2 = dot(l, l);
  float distance = sqrt(distance2);
  l /= distance;
  Light arriving = light.intensity;
#if defined(MIXED_FALLOFF)
  arriving /= mix(1.0, distance2, light.decays);
#elif defined(FALLOFF)
  arriving /= distance2;
#endif
#ifdef SHADOWS
  arriving *= step(occlusion(scene, from, l, distance), 0.0);
#endif
  return scattered(arriving, s, l, d);
}
#endif

#ifdef DIRECTIONAL_LIGHTS
Lit directionalLight(DirectionalLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  Light arriving = light.irradiance;
#ifdef SHADOWS
  arriving *= step(occlusion(scene, from, light.toLight, MISS), 0.0);
#endif
  return scattered(arriving, s, light.toLight, d);
}
#endif
