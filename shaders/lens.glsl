// Camera rays of paths, in units of the packed scene: from the camera, which is the origin; from a point of the lens to
// the point in focus; or from a plane ahead of the camera. Source of the lens: R. Cook, T. Porter, L. Carpenter, "Distributed
// Ray Tracing", SIGGRAPH 1984; M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th ed., section 5.2.3.
// Precision: f32; where that does not tell pixels apart, see EXACT_RAYS and DISTANT.
#include "generated/view.glsl"
#include "sampler.glsl"
#ifdef LENS
#include "circle.glsl"
#endif

// Where the sample lies, in pixels from the middle of its own. What all pixels share is free of noise where light is.
vec2 fromMiddle(Sampler random) {
#ifdef SHARED_PLACE
  vec2 place = vec2(eye.placeX, eye.placeY);
#else
  vec2 place = sample2d(random, 0xffffffffu);
#endif
  return vec2(place.x - 0.5, 0.5 - place.y);
}

vec3 windowPoint(Sampler random) {
  vec2 aside = fromMiddle(random);
#ifdef EXACT_RAYS
  // The middle of the pixel is exact (see `packEye` in view-record.ts). What is left tells the last digits of small
  // components.
  vec3 w = eye.corner + gl_FragCoord.x * eye.stepX + gl_FragCoord.y * eye.stepY;
  vec3 low = eye.corner2 + gl_FragCoord.x * eye.stepX2 + gl_FragCoord.y * eye.stepY2;
  return w + (low + (aside.x * (eye.stepX + eye.stepX2) + aside.y * (eye.stepY + eye.stepY2)));
#else
  vec2 at = gl_FragCoord.xy + aside;
  return eye.corner + at.x * eye.stepX + at.y * eye.stepY;
#endif
}

vec3 unitVector(vec3 v) {
  return v / sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// The start and the unit direction.
#if defined(DISTANT)
// The window is in that plane, and the origin its middle. Rays are parallel (spread = 0), or run away from a point that is
// far behind: a ray from there has the digits that tell pixels apart in its start, where they are not lost next to 1.
void cameraRay(Sampler random, out vec3 o, out vec3 d) {
  o = windowPoint(random);
  d = unitVector(eye.forward + eye.spread * o);
}
#elif defined(LENS)
void cameraRay(Sampler random, out vec3 o, out vec3 d) {
  vec2 u = sample2d(random, 0u);
  vec2 place = sqrt(u.y) * circle(u.x);
  o = place.x * eye.lensX + place.y * eye.lensY;
  d = unitVector(eye.focus * windowPoint(random) - o);
}
#else
void cameraRay(Sampler random, out vec3 o, out vec3 d) {
  o = vec3(0.0);
  d = unitVector(windowPoint(random));
}
#endif
