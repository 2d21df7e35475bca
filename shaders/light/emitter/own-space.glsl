// Shapes that shine in a space of their own, from where an affine map leads to the scene. They are asked for light there, in
// a direction d', which the linear part M of the map takes to one of the length s. Solid angles become |det M| / s³ times as
// large, since a thin cone of the solid angle w with sides of length 1 has the volume w / 3, and its image w' s³ / 3. The own
// space is packed in a unit that makes volumes as large as in the scene: |det M| = 1. Precision: f32.

vec3 toOwnSpace(Emitter e, vec3 v) {
  return vec3(dotInOrder(e.ownX, v), dotInOrder(e.ownY, v), dotInOrder(e.ownZ, v));
}

EmitterSample sampleOf(Emitter e, vec3 p, vec2 u, bool own) {
  if (e.inOwnSpace == 0.0) return ownSampleOf(e, p, u, own);
  EmitterSample s = ownSampleOf(e, toOwnSpace(e, p), u, own);
  vec3 way = s.direction.x * e.sceneX + s.direction.y * e.sceneY + s.direction.z * e.sceneZ;
  float size = sqrt(dotInOrder(way, way));
  return EmitterSample(way / size, s.distance * size, s.radiance, s.pdf * size * size * size, false, s.object);
}

float pdfOf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  if (e.inOwnSpace == 0.0) return ownPdfOf(e, from, d, t, cosine, own);
  vec3 p = toOwnSpace(e, from);
  vec3 way = toOwnSpace(e, d);
  float size = sqrt(dotInOrder(way, way));
  float met = ownCosine(e, t * way - wayTo(e, p), way / size);
  return ownPdfOf(e, p, way / size, t * size, met, own) / (size * size * size);
}
