// The unit direction of the camera ray through a window point, in pixels from the lower left corner. Rays start at the
// origin: the scene is packed relative to the camera. The sample's place in the pixel is already in `corner`.
vec3 cameraRay(vec2 point) {
  return normalize(view[0].corner + point.x * view[0].stepX + point.y * view[0].stepY);
}
