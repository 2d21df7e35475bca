// Integrator `direct`: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980, with the
// microfacet model of today. At every vertex the light of all lights through the full BRDF, then on along the mirror
// direction, weighted by Fresnel whatever the roughness. No random numbers: free of noise.
#include "nearest.glsl"
#include "surface.glsl"
#include "material/metallic-roughness.glsl"
#ifdef ENVIRONMENT
#include "light/environment.glsl"
#endif
#ifdef LIGHTS
#include "light/lights.glsl"
#endif

// What a camera ray shows that meets nothing.
vec4 background(vec3 d) {
#if defined(BACKGROUND_ENVIRONMENT)
  return vec4(environmentRadiance(d), 1.0);
#elif defined(BACKGROUND_COLOR)
  return vec4(view[0].background, 1.0);
#else
  return vec4(0.0);
#endif
}

vec4 direct(vec3 o, vec3 d) {
  vec3 radiance = vec3(0.0);
  Reflectance throughput = Reflectance(1.0);
  int own = NONE;
  for (int bounce = 0; bounce < BOUNCES; bounce++) {
    Hit hit = nearest(o, d, own);
    if (hit.object == NONE) {
      if (bounce == 0) return background(d);
#ifdef ENVIRONMENT
      radiance += throughput * environmentRadiance(d);
#endif
      break;
    }
    Surface s = surfaceAt(hit, o, d);
    radiance += throughput * lightAt(s, -d);
#ifdef REFLECTIONS
    throughput *= mirrorReflectance(s, -d);
    o = s.position;
    d = reflect(d, s.normal);
    own = hit.object;
#endif
  }
  return vec4(radiance, 1.0);
}
