// The plane equation, and the distance from the centre there, with a fixed offset.
const float OFFSET = 1e-4;

struct DiscFrom {
  vec3 o;
};

DiscFrom discFrom(Disc s, vec3 o) {
  return DiscFrom(o);
}

DiscFrom discFromCamera(Disc s) {
  return DiscFrom(vec3(0.0));
}

float discDistance(Disc s, DiscFrom from, vec3 d, float own) {
  float approach = dot(s.normal, d);
  if (abs(approach) < 1e-6) return MISS;
  float t = dot(s.center - from.o, s.normal) / approach;
  vec3 q = from.o + t * d - s.center;
  return t > OFFSET && dot(q, q) <= s.radius2 ? t : MISS;
}

float discOcclusion(Disc s, DiscFrom from, vec3 d, float limit, float own) {
  return limit - discDistance(s, from, d, own);
}

vec3 discNormal(Disc s, DiscFrom from, vec3 d, float weight) {
  return weight * (dot(s.normal, d) > 0.0 ? -s.normal : s.normal);
}
