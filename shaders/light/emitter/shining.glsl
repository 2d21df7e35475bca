// 1 where the side shines that faces the point: its front, or its back. Precision: exact.
float shines(Emitter e, bool front) {
  return e.side * (front ? 1.0 : -1.0) >= 0.0 ? 1.0 : 0.0;
}
