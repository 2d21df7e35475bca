// Ray against spheres that the camera is so close to, or in, that b² may be below r² at a hit: there b² - power tells more
// than r² less the square of what is aside, if the power is exact. See sphere.glsl. Precision: f32.

// What all rays from a point share: the way to the centre, and the power |c|² - r² of the point. It is exact where it was
// not worked out here, as a difference of squares in f32.
struct SphereFrom {
  vec3 c;
  float power;
  bool exact;
};

SphereFrom sphereFrom(Sphere s, vec3 o) {
  vec3 c = s.center - o;
  float power = dot(c, c) - s.radius2;
  return SphereFrom(c, power, false);
}

// From the camera, whose power was worked out in f64: next to a planet's surface, f32 would have none of it right.
SphereFrom sphereFromCamera(Sphere s) {
  return SphereFrom(s.center, s.power, true);
}

vec2 sphereChord(Sphere s, SphereFrom from, vec3 d) {
  float b = dot(from.c, d);
  vec3 aside = from.c - b * d;
  float b2 = b * b;
  return vec2(b, mix(s.radius2 - dot(aside, aside), b2 - from.power, from.exact && b2 < s.radius2));
}
