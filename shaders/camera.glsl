// The unit direction of the camera ray through a window point, in pixels from the lower left corner. Rays start at the
// origin: the scene is packed relative to the camera. The sample's place in the pixel is already in `corner`.
vec3 cameraRay(Eye eye, vec2 point) {
  vec3 d = eye.corner + point.x * eye.stepX + point.y * eye.stepY;
  return d / sqrt(dot(d, d));
}
