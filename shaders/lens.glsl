// Camera rays of paths, in units of the packed scene: from the camera, which is the origin; from a point of the lens to
// the point in focus; or side by side, all in one direction. The sample's place in the pixel is already in `corner`.
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
#if defined(ORTHOGRAPHIC)
void cameraRay(out vec3 o, out vec3 d) {
  o = windowPoint();
  d = eye.forward;
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
