// Asking one emitter of a scene for the light that it sends to a point. Of its kinds, those are here that the scene has.
// Points are relative to the camera, in units of the frame. Precision: f32.
#include "constants.glsl"
#include "split-dot.glsl"

struct EmitterSample {
  // Unit vector to the light.
  vec3 direction;
  // MISS: infinitely far away.
  float distance;
  // Radiance from there if nothing is in the way; of a light without extent, irradiance on a surface that faces it.
  vec3 radiance;
  // Per solid angle, times the probability of the emitter; of a light without extent, that probability.
  float pdf;
  // Whether the light has no extent, so that no ray meets it by chance.
  bool delta;
  // The object that shines, or -1: it does not stand in its own way.
  int object;
};

const EmitterSample NO_LIGHT = EmitterSample(vec3(0.0, 0.0, 1.0), 0.0, vec3(0.0), 0.0, false, -1);

#include "generated/emitters.glsl"

// Whether this emitter is the object `own`.
bool isObject(Emitter e, int own) {
#if defined(SPHERE_EMITTER) || defined(QUAD_EMITTER) || defined(DISC_EMITTER) || defined(TRIANGLE_EMITTER) || defined(BOX_EMITTER) || defined(CYLINDER_EMITTER)
  return own >= 0 && e.object == own;
#else
  return false;
#endif
}

#ifdef SEVERAL_EMITTERS
// Which one a random number from [0, 1) chooses, by the alias table of emitter-table.ts.
int chosenEmitter(float which) {
  float place = which * choice.count;
  float index = max(min(floor(place), choice.count - 1.0), 0.0);
  int i = int(index);
  return place - index < emitters[i].threshold ? i : emitters[i].alias;
}
#endif

// One emitter by way of `which`, and one direction to it by way of u, both from [0, 1); a pdf of 0 where no direction leads
// to it. `own` is the object whose surface p is on, or -1: of that, only what is across its inside is seen.
EmitterSample sampleEmitter(vec3 p, float which, vec2 u, int own) {
#ifdef SEVERAL_EMITTERS
  Emitter e = emitters[chosenEmitter(which)];
  EmitterSample s = sampleOf(e, p, u, isObject(e, own));
  s.pdf *= e.probability;
  return s;
#else
  return sampleOf(emitters[0], p, u, isObject(emitters[0], own));
#endif
}

#ifdef AREA_EMITTER
// The pdf, per solid angle, with which `sampleEmitter` finds the unit direction d; that meets the emitter at the distance t
// from `from`, under an angle of this cosine with the normal. 0 for what has no extent, which no ray meets.
float emitterPdf(int emitter, vec3 from, vec3 d, float t, float cosine, int own) {
  Emitter e = emitters[emitter];
  float pdf = pdfOf(e, from, d, t, cosine, isObject(e, own));
#ifdef SEVERAL_EMITTERS
  pdf *= e.probability;
#endif
  return pdf;
}

// The radiance that an emitter sends along -d; a ray with the direction d has met it.
vec3 emitterRadiance(int emitter, vec3 d) {
#ifdef IMAGE_EMITTER
  if (isImage(emitters[emitter])) return imageRadiance(emitters[emitter], d);
#endif
#ifdef AIMED_BALL
  return emitters[emitter].strength * profileAlong(emitters[emitter], -d);
#else
  return emitters[emitter].strength;
#endif
}
#endif
