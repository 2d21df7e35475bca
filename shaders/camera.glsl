// The unit direction of the camera ray of this fragment. Rays start at the origin: the scene is packed relative to the
// camera. The sample's place in the pixel is already in `corner`. Precision: f32.
#ifdef VARYINGS
in vec3 ray;
#else
#include "generated/view.glsl"
#endif

vec3 cameraRay() {
#ifdef VARYINGS
  vec3 d = ray;
#else
  vec3 d = eye.corner + gl_FragCoord.x * eye.stepX + gl_FragCoord.y * eye.stepY;
#ifdef EXACT_RAYS
  // That was exact (see `packEye` in view-record.ts), and this tells the last digits of small components.
  d += eye.corner2 + gl_FragCoord.x * eye.stepX2 + gl_FragCoord.y * eye.stepY2;
#endif
#endif
  return d / sqrt(dot(d, d));
}
