// Ray against disc: the plane at t = height / (n·d), then the distance from the centre there. `height` is the way from the
// ray's start to the plane along the normal, for the camera worked out in f64. Precision: f32; n·d where lengths differ
// widely as `splitDot`, since on a large disc nothing else is lost.
#include "split-dot.glsl"

// What all rays from a point share: the way to the centre, and to the plane.
struct DiscFrom {
  vec3 c;
  float height;
};

float discAlongNormal(Disc s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.normal, s.normal2, s.normal3, v);
#else
  return dotInOrder(s.normal, v);
#endif
}

DiscFrom discFrom(Disc s, vec3 o) {
  vec3 c = s.center - o;
#ifdef WIDE_RANGE
  c += s.centerLow;
  // Near the camera, what the height changes by on the way there: next to a large disc, nothing large cancels in it.
  bool near = dot(o, o) < 0.01 * dot(s.center, s.center);
  return DiscFrom(c, mix(discAlongNormal(s, c), s.height - discAlongNormal(s, o), near));
#else
  return DiscFrom(c, discAlongNormal(s, c));
#endif
}

DiscFrom discFromCamera(Disc s) {
  return DiscFrom(s.center, s.height);
}

// A ray within the plane gives no number, and so no hit. One that leaves the disc (own = 1) never meets it again.
float discDistance(Disc s, DiscFrom from, vec3 d, float own) {
  float t = from.height / discAlongNormal(s, d);
  vec3 q = from.c - t * d;
  bool meets = dot(q, q) <= s.radius2 && t > 0.0 && own < 0.5;
  return mix(MISS, t, meets);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float discOcclusion(Disc s, DiscFrom from, vec3 d, float limit, float own) {
  return limit - discDistance(s, from, d, own);
}
#endif

// The unit normal on the side that d comes from, times a weight.
vec3 discNormal(Disc s, DiscFrom at, vec3 d, float weight) {
  vec3 n = s.normal;
#ifdef WIDE_RANGE
  n += s.normal2 + s.normal3;
#endif
  return (discAlongNormal(s, d) > 0.0 ? -weight : weight) * n;
}

#ifdef SIDES
// Whether the ray comes from the side that the normal points to.
bool discFront(Disc s, DiscFrom at, vec3 d) {
  return discAlongNormal(s, d) <= 0.0;
}
#endif

#ifdef DISC_CHECKER
// The surface lengths (U, V) along the tangent and normal × tangent from the centre, counted in cells.
vec2 discCells(Disc s, vec3 p) {
  return vec2(s.startU + dot(s.cellU, p), s.startV + dot(s.cellV, p));
}
#endif
