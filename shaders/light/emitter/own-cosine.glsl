// The cosine of a unit direction with the normal where it met a solid that shines. Precision: f32.

#ifdef BOX_EMITTER
// q: from its middle.
float boxCosine(Emitter e, vec3 q, vec3 d) {
  vec3 beyond = abs(q) - e.edgeU;
  return beyond.x >= beyond.y && beyond.x >= beyond.z ? d.x : beyond.y >= beyond.z ? d.y : d.z;
}
#endif

#ifdef CYLINDER_EMITTER
// q: from the middle of its base.
float cylinderCosine(Emitter e, vec3 q, vec3 d) {
  float height = dotInOrder(e.axis, q);
  vec3 outwards = q - height * e.axis;
  float away = sqrt(dotInOrder(outwards, outwards));
  bool isCap = max(-height, height - e.height) > away - e.radius;
  return isCap ? dotInOrder(e.axis, d) : dotInOrder(outwards, d) / max(away, SMALLEST);
}
#endif
