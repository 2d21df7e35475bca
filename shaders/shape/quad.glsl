// Ray against parallelogram corner + u edgeU + v edgeV, 0 <= u, v <= 1: with the way c to the corner and both edges over
// the area, n·d, u n·d and v n·d are the triple products (edgeU, edgeV, d), (edgeV, c, d) and (c, edgeU, d); they are
// compared without dividing. For the camera the cross products come from f64. Source: Cramer's rule, as in T. Möller and
// B. Trumbore, JGT 2(1), 1997. Precision: f32; n·d where lengths differ widely as `splitDot`.
#include "split-dot.glsl"

// What all rays from a point share: the crosses edgeV × c and c × edgeU, and the way to the plane along the normal.
struct QuadFrom {
  vec3 alongU;
  vec3 alongV;
  float height;
};

float quadAlongNormal(Quad s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.normal, s.normal2, s.normal3, v);
#else
  return dotInOrder(s.normal, v);
#endif
}

QuadFrom quadFrom(Quad s, vec3 o) {
  vec3 c = s.corner - o;
#ifdef WIDE_RANGE
  c += s.cornerLow;
  // Near the camera, what the height changes by on the way there: next to a large quad, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * dot(s.corner, s.corner);
  float height = mix(quadAlongNormal(s, c), s.height - quadAlongNormal(s, o), near);
#else
  float height = quadAlongNormal(s, c);
#endif
  return QuadFrom(cross(s.edgeV, c), cross(c, s.edgeU), height);
}

QuadFrom quadFromCamera(Quad s) {
  return QuadFrom(s.alongU, s.alongV, s.height);
}

// A ray within the plane gives no number, and so no hit. One that leaves the quad (own = 1) never meets it again.
float quadDistance(Quad s, QuadFrom from, vec3 d, float own) {
  float approach = quadAlongNormal(s, d);
  float t = from.height / approach;
  float facing = sign(approach);
  vec2 place = facing * vec2(dotInOrder(from.alongU, d), dotInOrder(from.alongV, d));
  float inside = min(min(place.x, place.y), abs(approach) - max(place.x, place.y));
  bool meets = inside >= 0.0 && t > 0.0 && own < 0.5;
  return mix(MISS, t, meets && t < MISS);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float quadOcclusion(Quad s, QuadFrom from, vec3 d, float limit, float own) {
  return limit - quadDistance(s, from, d, own);
}
#endif

// The unit normal on the side that d comes from, times a weight.
vec3 quadNormal(Quad s, QuadFrom at, vec3 d, float weight) {
  vec3 n = s.normal;
#ifdef WIDE_RANGE
  n += s.normal2 + s.normal3;
#endif
  return (quadAlongNormal(s, d) > 0.0 ? -weight : weight) * n;
}

#ifdef SIDES
// Whether the ray comes from the side that the normal points to.
bool quadFront(Quad s, QuadFrom at, vec3 d) {
  return quadAlongNormal(s, d) <= 0.0;
}
#endif

#ifdef QUAD_CHECKER
// The surface lengths (U, V) along the edges from the corner, counted in cells.
vec2 quadCells(Quad s, vec3 p) {
  return vec2(s.startU + dot(s.cellU, p), s.startV + dot(s.cellV, p));
}
#endif
