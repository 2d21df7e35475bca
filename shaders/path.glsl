// Integrator `path`: unidirectional path tracing with next-event estimation and multiple importance sampling by the power
// heuristic. Source: J. Kajiya, "The Rendering Equation", SIGGRAPH 1986; E. Veach, "Robust Monte Carlo Methods for Light
// Transport Simulation", 1997, section 9.2.3; Russian roulette with the indices of refraction left out of the throughput as in
// M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th ed., section 13.4. What is computed, and the table of
// random numbers: docs/light-transport.md. Precision: f32.
#include "constants.glsl"
#include "sampler.glsl"
#include "lens.glsl"
#include "surface-frame.glsl"
#include "checker.glsl"
#ifdef ENVIRONMENT
#include "light/environment.glsl"
#endif
#include "generated/objects.glsl"
#include "background.glsl"
#include "material/bsdf.glsl"
#ifdef SOLID
#include "media.glsl"
#endif
#include "vertex.glsl"
#ifdef GLINT
#include "glint.glsl"
#endif
#ifdef SHADOWS
#include "light/emitters.glsl"

#ifdef AREA_EMITTER
// The weight of a direction that was found with pdf a and not with b: as a quotient, so that no square leaves the range.
// Where all lights are asked at every surface, what they are asked for is not found again.
float powerHeuristic(float a, float b) {
#ifdef WHITTED
  return 0.0;
#else
  float ratio = min(a, b) / max(a, b);
  float square = ratio * ratio;
  return (a < b ? square : 1.0) / (1.0 + square);
#endif
}
#endif

// The light of an emitter by way of a surface, where the ray that is to be shaded goes off at `from`.
#ifdef GLINT
vec3 lightBy(EmitterSample light, Parts scene, From from, mat3 frame, Bsdf bsdf, vec3 wo, Glints glints) {
#else
vec3 lightBy(EmitterSample light, Parts scene, From from, mat3 frame, Bsdf bsdf, vec3 wo) {
#endif
  float pdf;
  vec3 wi = toLocal(frame, light.direction);
  vec3 value = bsdfValue(bsdf, wo, wi, pdf);
  if (!(light.pdf > 0.0 && max(max(value.r, value.g), value.b) > 0.0)) return vec3(0.0);
  if (occlusion(scene, from, light.direction, light.distance, light.object) > 0.0) return vec3(0.0);
#if defined(WHITTED) || !defined(AREA_EMITTER)
  return value * light.radiance / light.pdf;
#else
#ifdef GLINT
  if (!light.delta) pdf = pdfWithGlints(glints, wi, pdf, -1, 0.0);
#endif
  return value * light.radiance * ((light.delta ? 1.0 : powerHeuristic(light.pdf, pdf)) / light.pdf);
#endif
}
#endif
#ifdef WHITTED
#include "whitted.glsl"
#endif

#ifdef SUN_EMITTER
// The suns that a direction points into, weighted as what the BSDF found with this pdf.
vec3 sunsAt(vec3 d, float pdf) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < EMITTERS; i++) {
    if (!isSun(emitters[i])) continue;
    float asked = emitterPdf(i, vec3(0.0), d, MISS, 1.0, -1);
    if (asked > 0.0) light += (pdf > 0.0 ? powerHeuristic(pdf, asked) : 1.0) * emitters[i].strength;
  }
  return light;
}
#endif
#ifdef IMAGE_EMITTER
// The image of the surroundings, weighted in the same way.
vec3 imageAt(vec3 d, float pdf) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < EMITTERS; i++) {
    if (!isImage(emitters[i])) continue;
    float weight = pdf > 0.0 ? powerHeuristic(pdf, emitterPdf(i, vec3(0.0), d, MISS, 1.0, -1)) : 1.0;
    light += weight * imageRadiance(emitters[i], d);
  }
  return light;
}
#endif

bool isBlack(vec3 color) {
  return max(max(color.r, color.g), color.b) <= 0.0;
}

vec4 path() {
  Parts scene = loadParts();
  Sampler random = pixelSampler(eye.sequence, eye.reversed);
  vec3 p;
  vec3 d;
  cameraRay(random, p, d);
#if defined(LENS) || defined(DISTANT)
  From from = fromPoint(scene, p, NOTHING);
#else
  From from = fromCamera(scene);
#endif
  vec3 radiance = vec3(0.0);
  vec3 throughput = vec3(1.0);
#ifdef CLAMP
  // What shines where the camera sees it.
  vec3 seen = vec3(0.0);
#endif
#ifdef AREA_EMITTER
  // Where the ray under way was scattered, and its pdf; 0 where no light could have been asked for it.
  float scatteredPdf = 0.0;
#endif
#ifdef SOLID
  Media media = startMedia(scene);
  float refraction = 1.0;
#endif
  for (int event = 0; event <= BOUNCES; event++) {
    Hit hit = nearest(scene, from, d);
    if (!(hit.t < MISS)) {
#ifdef BACKGROUND_IMAGE
      if (event == 0) return background(scene, d) + vec4(imageAt(d, 0.0), 0.0);
#else
      if (event == 0) return background(scene, d);
#endif
#ifdef ENVIRONMENT
      radiance += throughput * environmentRadiance(scene.surroundings, d);
#endif
#ifdef SUN_EMITTER
      radiance += throughput * sunsAt(d, scatteredPdf);
#endif
#ifdef IMAGE_EMITTER
      radiance += throughput * imageAt(d, scatteredPdf);
#endif
      break;
    }
#ifdef ATTENUATION
    throughput *= transmittance(media, hit.t);
#endif
#if defined(EMISSIVE) && defined(AREA_EMITTER)
    vec3 start = p;
    int left = from.own.object;
#endif
    p += hit.t * d;
    from = fromPoint(scene, p, hit);
    Met met = metAt(scene, from, d);
    vec3 n = met.normal;
    Material m = met.material;
    float cosine = max(-dotInOrder(n, d), 0.0);
#ifdef SIDES
    bool front = met.front;
#endif
#ifdef EMISSIVE
    if (!isBlack(m.emission)) {
      float shines = front ? m.shinesInFront : m.shinesBehind;
#ifdef AREA_EMITTER
      if (scatteredPdf > 0.0 && m.emitter >= 0) {
        shines *= powerHeuristic(scatteredPdf, emitterPdf(m.emitter, start, d, hit.t, cosine, left));
      }
#endif
#ifdef AIMED_BALL
      radiance += (shines * throughput) * (m.emitter >= 0 ? emitterRadiance(m.emitter, d) : m.emission);
#else
      radiance += (shines * throughput) * m.emission;
#endif
    }
#endif
#ifdef CLAMP
    if (event == 0) {
      seen = radiance;
      radiance = vec3(0.0);
    }
#endif
    if (event == BOUNCES) break;

#if defined(THIN) && defined(SOLID)
    bool closed = isClosed(hit.object);
#elif defined(SOLID)
    bool closed = true;
#else
    bool closed = false;
#endif
#ifdef SOLID
    float eta = closed ? relativeIndex(m.ior, media, hit.object, front) : m.ior;
    Media beyond = media;
    if (closed && front) beyond = enter(media, hit.object, m);
    if (closed && !front) beyond = leave(media, hit.object);
#elif defined(TRANSMISSION)
    float eta = m.ior;
#else
    float eta = 1.0;
#endif
    Bsdf bsdf = bsdfAt(m, eta, closed);
    mat3 frame = surfaceFrame(n);
    vec3 wo = toLocal(frame, -d);
    wo.z = cosine;
    uint sets = 4u * uint(event);
#ifdef WHITTED
    radiance += throughput * lightOfAll(scene, from, p, n, frame, bsdf, wo, sample2d(random, 2u + sets));
    BsdfSample onward = mirrorSample(bsdf, wo, sample2d(random, 4u + sets).y);
#else
    vec2 chance = sample2d(random, 3u + sets);
#ifdef GLINT
    Glints glints = glintsAt(p, hit.object, event + 1 < BOUNCES, frame, bsdf, wo);
#endif
#ifdef SHADOWS
    if (!isMirrorOnly(bsdf)) {
      EmitterSample light = sampleEmitter(p, chance.x, sample2d(random, 2u + sets), hit.object);
#ifdef ATTENUATION
      if (dotInOrder(light.direction, n) < 0.0) light.radiance *= transmittance(beyond, light.distance);
      else light.radiance *= transmittance(media, light.distance);
#endif
#ifdef GLINT
      radiance += throughput * lightBy(light, scene, from, frame, bsdf, wo, glints);
#else
      radiance += throughput * lightBy(light, scene, from, frame, bsdf, wo);
#endif
    }
#endif
#ifdef GLINT
    BsdfSample onward = sampleWithGlints(bsdf, wo, glints, sample2d(random, 1u + sets), chance.y);
#else
    BsdfSample onward = bsdfSample(bsdf, wo, sample2d(random, 1u + sets), chance.y);
#endif
#endif
    throughput *= onward.weight;
    if (isBlack(throughput)) break;
#ifdef SOLID
    if (onward.wi.z < 0.0 && closed) {
      media = beyond;
      refraction *= eta * eta;
    }
#endif
#ifdef ROULETTE
    if (event >= ROULETTE_FROM) {
      float survival = max(max(throughput.r, throughput.g), throughput.b);
#ifdef SOLID
      survival *= refraction;
#endif
      survival = min(survival, 1.0);
      if (sample2d(random, 4u + sets).x >= survival) break;
      throughput /= survival;
    }
#endif
#ifdef AREA_EMITTER
    scatteredPdf = onward.pdf;
#endif
    d = toWorld(frame, onward.wi);
    d /= sqrt(dotInOrder(d, d));
  }
#ifdef CLAMP
  // Dimmed, not cut channel by channel: its colour stays.
  radiance *= min(eye.mostRadiance / max(max(max(radiance.r, radiance.g), radiance.b), SMALLEST), 1.0);
  radiance += seen;
#endif
  return vec4(min(radiance, vec3(LARGEST)), 1.0);
}
