// Ray against sphere where rays pass through surfaces: from either side, and through the sphere itself. See sphere.glsl.
// Precision: f32.

// The distance to the sphere, or MISS, from outside or inside. The roots are power / q and q; that of a ray that leaves
// the sphere itself (own = 1) is the one nearer to 0, so that q is left if it is ahead.
float sphereDistance(Sphere s, SphereFrom from, vec3 d, float own) {
  vec2 chord = sphereChord(s, from, d);
  // From inside, -power at least: no rounding makes such a ray miss.
  float chord2 = max(chord.y, -from.power);
  float root = sqrt(max(chord2, 0.0));
  bool outside = from.power > 0.0;
  bool leaves = own > 0.5;
  bool ahead = chord.x > 0.0;
  float q = chord.x + mix(-root, root, ahead);
  float t = mix(q, from.power / q, !leaves && outside == ahead);
  return mix(MISS, t, chord2 > 0.0 && (ahead || !(leaves || outside)));
}

#ifdef SHADOWS
// Above 0 where the sphere stands between a point and another, `limit` away.
float sphereOcclusion(Sphere s, SphereFrom from, vec3 d, float limit, float own) {
  return limit - sphereDistance(s, from, d, own);
}
#endif

// The unit normal on the side that d comes from, times a weight: outwards where the centre is ahead.
vec3 sphereNormal(Sphere s, SphereFrom from, vec3 d, float weight) {
#ifdef WIDE_RANGE
  float perRadius = weight * abs(sphereCurvature(s, from));
#else
  float perRadius = weight * abs(s.curvature);
#endif
  return (dot(from.c, d) > 0.0 ? -perRadius : perRadius) * from.c;
}

#ifdef SIDES
// Whether the ray comes from outside: the centre is ahead.
bool sphereFront(Sphere s, SphereFrom from, vec3 d) {
  return dot(from.c, d) > 0.0;
}
#endif
