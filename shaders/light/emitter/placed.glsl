// The way from p to where an emitter is. Precision: f32, and with WIDE_RANGE what f32 lost of the position is added.
vec3 wayTo(Emitter e, vec3 p) {
#ifdef WIDE_RANGE
  return (e.position - p) + e.positionLow;
#else
  return e.position - p;
#endif
}
