// The way from p to where an emitter is.
vec3 wayTo(Emitter e, vec3 p) {
#ifdef WIDE_RANGE
  return (e.position - p) + e.positionLow;
#else
  return e.position - p;
#endif
}
