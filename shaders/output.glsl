// `output`: what the first surface on the way of a camera ray is like, in place of its light, as the linear colour whose
// sRGB encoding is: its normal on the side of the camera, 0.5 n + 0.5 in the axes of the scene; how near it is,
// 1 / (1 + t / T), t along the ray, T the distance of what is in focus, by default of the camera's target; or its base
// colour, which is linear as it is. Precision: f32.
#include "constants.glsl"
#include "sampler.glsl"
#include "lens.glsl"
#include "checker.glsl"
#include "generated/objects.glsl"

// The inverse of `encodeSrgb`, on [0, 1]. Source: IEC 61966-2-1:1999, section 5.2.
vec3 decodeSrgb(vec3 encoded) {
  vec3 c = clamp(encoded, 0.0, 1.0);
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

vec4 firstSurface() {
  Parts scene = loadParts();
  vec3 p;
  vec3 d;
  cameraRay(pixelSampler(eye.sequence, eye.reversed), p, d);
#if defined(LENS) || defined(DISTANT)
  From from = fromPoint(scene, p, NOTHING);
#else
  From from = fromCamera(scene);
#endif
  Hit hit = nearest(scene, from, d);
  if (!(hit.t < MISS)) return vec4(0.0);
#ifdef DEPTH
  float t = hit.t;
#ifdef DISTANT
  // From the camera, which is behind where the ray starts.
  vec3 aside = eye.spread * p;
  t += eye.toStart * sqrt(1.0 + dotInOrder(aside, aside));
#endif
  return vec4(decodeSrgb(vec3(eye.toFocus / (eye.toFocus + t))), 1.0);
#else
  p += hit.t * d;
  from = fromPoint(scene, p, hit);
#ifdef NORMAL
  return vec4(decodeSrgb(0.5 * metAt(scene, from, d).normal + 0.5), 1.0);
#else
  return vec4(metAt(scene, from, d).material.color, 1.0);
#endif
#endif
}
