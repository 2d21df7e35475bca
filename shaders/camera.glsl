// The unit direction of the camera ray of this fragment. Rays start at the origin: the scene is packed relative to the
// camera. The sample's place in the pixel is already in `corner`.
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
#endif
  return d / sqrt(dot(d, d));
}
