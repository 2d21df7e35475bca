// The light that point and directional lights send to the eye by way of a surface. The 1 / pi of every BRDF is already
// in the packed intensities. Precision: f32.

// Light that arrives along -l, `strength` times as strong as `color`, times BRDF and cosine; 0 from behind the surface.
vec3 scattered(vec3 color, float strength, Surface s, vec3 l, vec3 d) {
  float nl = max(dot(s.normal, l), 0.0);
  float received = strength * nl;
#ifdef HIGHLIGHTS
  vec3 h = l - d;
  float weight = schlickWeight(0.5 * sqrt(dot(h, h)));
  float lobe = received * ggxLobe(s.material.alpha2, s.normal, h, nl, s.nv);
  Reflectance specular = lobe * fresnel(s.material, weight);
#ifdef DIELECTRIC
  return (s.material.color * (received * diffuseShare(s.material, weight)) + specular) * color;
#else
  return specular * color;
#endif
#else
  return (s.material.color * received) * color;
#endif
}

#ifdef POINT_LIGHTS
vec3 pointLight(PointLight light, Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 l = light.position - p;
  float distance2 = dot(l, l);
  float distance = sqrt(distance2);
  l /= max(distance, SMALLEST);
  float strength = 1.0;
#if defined(MIXED_FALLOFF)
  strength /= mix(1.0, max(distance2, SMALLEST), light.decays);
#elif defined(FALLOFF)
  strength /= max(distance2, SMALLEST);
#endif
#ifdef SHADOWS
  strength *= step(occlusion(scene, from, l, distance), 0.0);
#endif
  return scattered(light.intensity, strength, s, l, d);
}
#endif

#ifdef DIRECTIONAL_LIGHTS
#include "light/directional.glsl"
#endif
