// The quadratic formula, as in P. Shirley, Ray Tracing in One Weekend (2020), section 5.2, with a fixed offset.
const float OFFSET = 1e-4;

struct SphereFrom {
  vec3 o;
};

SphereFrom sphereFrom(Sphere s, vec3 o) {
  return SphereFrom(o);
}

SphereFrom sphereFromCamera(Sphere s) {
  return SphereFrom(vec3(0.0));
}

float sphereDistance(Sphere s, SphereFrom from, vec3 d, float own) {
  vec3 oc = from.o - s.center;
  float a = dot(d, d);
  float b = 2.0 * dot(oc, d);
  float c = dot(oc, oc) - s.radius2;
  float discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return MISS;
  float root = sqrt(discriminant);
  float near = (-b - root) / (2.0 * a);
  float far = (-b + root) / (2.0 * a);
  return near > OFFSET ? near : (far > OFFSET ? far : MISS);
}

float sphereOcclusion(Sphere s, SphereFrom from, vec3 d, float limit, float own) {
  return limit - sphereDistance(s, from, d, own);
}

vec3 sphereNormal(Sphere s, SphereFrom from, vec3 d, float weight) {
  vec3 n = normalize(from.o - s.center);
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
