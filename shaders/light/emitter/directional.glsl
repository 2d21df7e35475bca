// Parallel light. Precision: f32.
EmitterSample directionalSample(Emitter e, vec3 p, vec2 u, bool own) {
  return EmitterSample(e.axis, MISS, e.strength, 1.0, true, -1);
}
