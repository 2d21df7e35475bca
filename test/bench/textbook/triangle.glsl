// T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997, with a fixed offset.
const float OFFSET = 1e-4;

struct TriangleFrom {
  vec3 o;
};

TriangleFrom triangleFrom(Triangle s, vec3 o) {
  return TriangleFrom(o);
}

TriangleFrom triangleFromCamera(Triangle s) {
  return TriangleFrom(vec3(0.0));
}

float triangleDistance(Triangle s, TriangleFrom from, vec3 d, float own) {
  vec3 edge1 = s.b - s.a;
  vec3 edge2 = s.c - s.a;
  vec3 p = cross(d, edge2);
  float determinant = dot(edge1, p);
  if (abs(determinant) < 1e-12) return MISS;
  vec3 way = from.o - s.a;
  float u = dot(way, p) / determinant;
  if (u < 0.0 || u > 1.0) return MISS;
  vec3 q = cross(way, edge1);
  float v = dot(d, q) / determinant;
  if (v < 0.0 || u + v > 1.0) return MISS;
  float t = dot(edge2, q) / determinant;
  return t > OFFSET ? t : MISS;
}

float triangleOcclusion(Triangle s, TriangleFrom from, vec3 d, float limit, float own) {
  return limit - triangleDistance(s, from, d, own);
}

vec3 triangleNormal(Triangle s, TriangleFrom from, vec3 d, float weight) {
  return weight * (dot(s.normal, d) > 0.0 ? -s.normal : s.normal);
}
