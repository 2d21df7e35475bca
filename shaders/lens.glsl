// Camera rays of paths, in units of the packed scene: from the camera, which is the origin; from a point of the lens to
// the point in focus; or from a plane ahead of the camera. The sample's place in the pixel is already in `corner`.
#include "generated/view.glsl"
#ifdef LENS
#include "circle.glsl"
#endif

vec3 windowPoint() {
  vec3 w = eye.corner + gl_FragCoord.x * eye.stepX + gl_FragCoord.y * eye.stepY;
#ifdef EXACT_RAYS
  // That was exact (see `packEye` in view-record.ts), and this tells the last digits of small components.
  w += eye.corner2 + gl_FragCoord.x * eye.stepX2 + gl_FragCoord.y * eye.stepY2;
#endif
  return w;
}

vec3 unitVector(vec3 v) {
  return v / sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// The start and the unit direction; u says where on the lens.
#if defined(DISTANT)
// The window is in that plane, and the origin its middle. Rays are parallel (spread = 0), or run away from a point that is
// far behind: a ray from there has the digits that tell pixels apart in its start, where they are not lost next to 1.
void cameraRay(out vec3 o, out vec3 d) {
  o = windowPoint();
  d = unitVector(eye.forward + eye.spread * o);
}
#elif defined(LENS)
void cameraRay(vec2 u, out vec3 o, out vec3 d) {
  vec2 place = sqrt(u.y) * circle(u.x);
  o = place.x * eye.lensX + place.y * eye.lensY;
  d = unitVector(eye.focus * windowPoint() - o);
}
#else
void cameraRay(out vec3 o, out vec3 d) {
  o = vec3(0.0);
  d = unitVector(windowPoint());
}
#endif
