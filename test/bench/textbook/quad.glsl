// T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997, for a parallelogram. The
// edges are packed over the area, which cancels.
const float OFFSET = 1e-4;

struct QuadFrom {
  vec3 o;
};

QuadFrom quadFrom(Quad s, vec3 o) {
  return QuadFrom(o);
}

QuadFrom quadFromCamera(Quad s) {
  return QuadFrom(vec3(0.0));
}

float quadDistance(Quad s, QuadFrom from, vec3 d, float own) {
  float area2 = 1.0 / dot(cross(s.edgeU, s.edgeV), s.normal);
  vec3 edge1 = area2 * s.edgeU;
  vec3 edge2 = area2 * s.edgeV;
  vec3 p = cross(d, edge2);
  float determinant = dot(edge1, p);
  if (abs(determinant) < 1e-12) return MISS;
  vec3 way = from.o - s.corner;
  float u = dot(way, p) / determinant;
  if (u < 0.0 || u > 1.0) return MISS;
  vec3 q = cross(way, edge1);
  float v = dot(d, q) / determinant;
  if (v < 0.0 || v > 1.0) return MISS;
  float t = dot(edge2, q) / determinant;
  return t > OFFSET ? t : MISS;
}

float quadOcclusion(Quad s, QuadFrom from, vec3 d, float limit, float own) {
  return limit - quadDistance(s, from, d, own);
}

vec3 quadNormal(Quad s, QuadFrom from, vec3 d, float weight) {
  return weight * (dot(s.normal, d) > 0.0 ? -s.normal : s.normal);
}
