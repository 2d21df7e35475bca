// Ray against spheres of which one or more hold the camera, and so all rays. See sphere.glsl. Precision: f32.

// The distance to the sphere, or MISS. For a ray that leaves the sphere itself (own = 1), its own root t = 0 is divided out:
// from inside the other one is left, from outside none.
float sphereDistance(Sphere s, SphereFrom from, vec3 d, float own) {
  vec2 chord = sphereChord(s, from, d);
  float root = sqrt(max(chord.y, 0.0));
  float t = mix(MISS, from.power / (chord.x + root), min(chord.x, chord.y) > 0.0);
  float through = chord.x + root;
  float back = mix(-from.power / (root - chord.x), MISS, own > 0.5);
  return mix(t, mix(back, through, chord.x > 0.0), s.curvature > 0.0);
}

#ifdef SHADOWS
// Above 0 where the sphere stands between its outside point and one `limit` away, which is outside too.
float sphereOcclusion(Sphere s, SphereFrom from, vec3 d, float limit, float own) {
  vec2 chord = sphereChord(s, from, d);
  return min(min(min(chord.x, limit - chord.x), chord.y), -s.curvature);
}
#endif
