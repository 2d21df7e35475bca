// Light from infinitely far away, from everywhere: radiance mean + slope y, y the height of the unit direction. Precision: f32.
vec3 environmentRadiance(Surroundings s, vec3 d) {
#ifdef GRADIENT
  return s.mean + d.y * s.slope;
#else
  return s.mean;
#endif
}

#ifdef DIELECTRIC
// Irradiance over pi on a surface that sees half of it: (mean + slope y) cos, integrated over the hemisphere.
vec3 environmentIrradiance(Surroundings s, vec3 n) {
#ifdef GRADIENT
  return s.mean + (2.0 / 3.0 * n.y) * s.slope;
#else
  return s.mean;
#endif
}
#endif
