// Integrator `direct`: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980, with the
// microfacet model of today. At every vertex the light of all lights through the full BRDF, then on along the mirror
// direction, weighted by Fresnel whatever the roughness. No random numbers: free of noise. Precision: f32.
#include "constants.glsl"
#include "material/metallic-roughness.glsl"
#include "surface.glsl"
#ifdef ENVIRONMENT
#include "light/environment.glsl"
#endif
#include "checker.glsl"
#include "generated/objects.glsl"
#include "background.glsl"

// The light that a surface at p sends towards the eye, along -d.
vec3 lightFrom(Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 light = vec3(0.0);
#ifdef LIGHTS
  light += lightAt(scene, from, s, p, d);
#endif
#if defined(ENVIRONMENT) && defined(DIELECTRIC)
  vec3 irradiance = environmentIrradiance(scene.surroundings, s.normal);
#ifdef REFLECTIVE
  irradiance *= diffuseShare(s.material, schlickWeight(s.nv));
#endif
  light += s.material.color * irradiance;
#endif
  return light;
}

Surface surfaceAt(Parts scene, From from, vec3 p, vec3 d) {
#if defined(INDEXED) && defined(REFLECTIVE)
  Met met = metAt(scene, from, d);
  return Surface(met.normal, met.material, abs(dot(met.normal, d)));
#elif defined(INDEXED)
  Met met = metAt(scene, from, d);
  return Surface(met.normal, met.material);
#elif defined(REFLECTIVE)
  vec3 n = normalAt(scene, from, d);
  return Surface(n, materialAt(scene, from, p), abs(dot(n, d)));
#else
  vec3 n = normalAt(scene, from, d);
  return Surface(n, materialAt(scene, from, p));
#endif
}

// There is no early way out for rays that miss everything: what they compute is thrown away at the end. Software
// rasterisers run both sides of every branch for each group of pixels, and pay for the branch.
vec4 direct(vec3 d) {
  Parts scene = loadParts();
  From from = fromCamera(scene);
  Hit hit = nearest(scene, from, d);
  vec4 behind = background(scene, d);
  bool seen = hit.t < MISS;
  vec3 p = hit.t * d;
  vec3 radiance = vec3(0.0);
#ifdef REFLECTIONS
  Reflectance throughput = Reflectance(1.0);
#ifdef INDEXED
  // Not a `do` loop: with loops inside of it, SwiftShader goes on with pixels that have left it.
  for (float bounce = 0.0; bounce < BOUNCES && hit.t < MISS; bounce += 1.0) {
#else
  float bounce = 0.0;
  do {
#endif
    from = fromPoint(scene, p, hit);
    Surface s = surfaceAt(scene, from, p, d);
    // Over |n|², so that d keeps its length to the last bit: else an error of it would grow eightfold with each bounce.
    vec3 mirrored = d + (2.0 * s.nv / dot(s.normal, s.normal)) * s.normal;
    radiance += throughput * lightFrom(scene, from, s, p, d);
    throughput *= fresnel(s.material, schlickWeight(s.nv));
    d = mirrored;
    hit = nearest(scene, from, d);
    p += hit.t * d;
#ifdef INDEXED
  }
#else
    bounce += 1.0;
    // No distance is below 0, so the last bounce ends it too.
  } while (hit.t < MISS * step(bounce, BOUNCES - 1.0));
#endif
#ifdef ENVIRONMENT
  radiance += throughput * mix(environmentRadiance(scene.surroundings, d), vec3(0.0), bvec3(hit.t < MISS));
#endif
#else
  from = fromPoint(scene, p, hit);
  radiance = lightFrom(scene, from, surfaceAt(scene, from, p, d), p, d);
#endif
  return mix(behind, vec4(min(radiance, vec3(LARGEST)), 1.0), bvec4(seen));
}
