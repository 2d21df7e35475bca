// Ray against sphere without cancellation, for rays |d| = 1 and points o relative to the camera.
// Source: E. Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7 (2019): the
// discriminant from the part of the centre perpendicular to the ray, the roots without subtraction. Here the power of
// the point is a product, (|c| - r)(|c| + r), and the discriminant takes whichever of its two forms is the more exact.

// The nearest distance t > 0, or MISS. A ray that leaves the sphere itself (`own`) has its own root t = 0 divided out:
// what is left is linear in t.
float sphereDistance(Sphere s, vec3 o, vec3 d, bool own) {
  vec3 c = s.center - o;
  float b = dot(c, d);
  if (own) return b > 0.0 ? 2.0 * b : MISS;
  float distance = length(c);
  float power = (distance - s.radius) * (distance + s.radius);
  if (power > 0.0 && b <= 0.0) return MISS;
  vec3 aside = c - b * d;
  float r2 = s.radius * s.radius;
  float discriminant = b * b < r2 ? b * b - power : r2 - dot(aside, aside);
  if (discriminant < 0.0) return MISS;
  float q = b + (b < 0.0 ? -sqrt(discriminant) : sqrt(discriminant));
  return power > 0.0 ? power / q : max(q, power / q);
}

// The outward unit normal at a point of the sphere.
vec3 sphereNormal(Sphere s, vec3 p) {
  return (p - s.center) / s.radius;
}
