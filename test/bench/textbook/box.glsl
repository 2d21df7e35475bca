// Slabs with the reciprocal of the direction: A. Williams et al., "An Efficient and Robust Ray-Box Intersection
// Algorithm", JGT 10(1), 2005, with a fixed offset.
const float OFFSET = 1e-4;

struct BoxFrom {
  vec3 o;
};

BoxFrom boxFrom(Box s, vec3 o) {
  return BoxFrom(o);
}

BoxFrom boxFromCamera(Box s) {
  return BoxFrom(vec3(0.0));
}

float boxDistance(Box s, BoxFrom from, vec3 d, float own) {
  vec3 inverse = 1.0 / d;
  vec3 a = (s.low - from.o) * inverse;
  vec3 b = (s.high - from.o) * inverse;
  vec3 entries = min(a, b);
  vec3 exits = max(a, b);
  float near = max(max(entries.x, entries.y), entries.z);
  float far = min(min(exits.x, exits.y), exits.z);
  if (near > far) return MISS;
  return near > OFFSET ? near : (far > OFFSET ? far : MISS);
}

float boxOcclusion(Box s, BoxFrom from, vec3 d, float limit, float own) {
  return limit - boxDistance(s, from, d, own);
}

vec3 boxNormal(Box s, BoxFrom from, vec3 d, float weight) {
  vec3 q = (from.o - 0.5 * (s.low + s.high)) / (s.high - s.low);
  vec3 size = abs(q);
  vec3 n = size.x > max(size.y, size.z) ? vec3(1, 0, 0) : (size.y > size.z ? vec3(0, 1, 0) : vec3(0, 0, 1));
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
