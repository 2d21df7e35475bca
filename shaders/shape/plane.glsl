// Ray against plane: t = height / (down·d), `down` being the unit vector from the camera's side, where all rays are, into
// the plane. So the plane is met where down·d > 0, and nothing that it could hide is ever lit (see `dimmed` in
// pack-scene.ts). Level planes get by with the y component, a sign.

#if defined(TILTED_PLANE) && defined(WIDE_RANGE)
#include "split-dot.glsl"
#endif

// What all rays from a point share: its height above the plane.
struct PlaneFrom {
  float height;
};

#ifdef TILTED_PLANE
vec3 planeDown(Plane s) {
#ifdef WIDE_RANGE
  return s.down + (s.down2 + s.down3);
#else
  return s.down;
#endif
}

float planeDescent(Plane s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.down, s.down2, s.down3, v);
#else
  return dot(s.down, v);
#endif
}
#endif

PlaneFrom planeFrom(Plane s, vec3 o) {
#if defined(TILTED_PLANE) && defined(WIDE_RANGE)
  // Near the camera, what the height changes by on the way there; near the plane's point, that from there.
  bool near = dot(o, o) < 0.01 * dot(s.point, s.point);
  return PlaneFrom(mix(planeDescent(s, (s.point - o) + s.pointLow), s.height - planeDescent(s, o), near));
#elif defined(TILTED_PLANE)
  return PlaneFrom(s.height - planeDescent(s, o));
#else
  return PlaneFrom(s.height - s.downY * o.y);
#endif
}

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(s.height);
}

#ifdef THROUGH
#include "shape/plane-through.glsl"
#else
// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again: the sign of y
// says so where the plane is level, but where it is tilted rounding may turn a ray that just grazes it.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
#ifdef TILTED_PLANE
  float approach = planeDescent(s, d);
  bool meets = min(approach, 0.5 - own) > 0.0;
#else
  float approach = s.downY * d.y;
  bool meets = approach > 0.0;
#endif
  return mix(MISS, from.height / approach, meets);
}

// The unit normal times a weight.
vec3 planeNormal(Plane s, PlaneFrom from, vec3 d, float weight) {
#ifdef TILTED_PLANE
  return -weight * planeDown(s);
#else
  return vec3(0.0, -weight * s.downY, 0.0);
#endif
}
#endif

#ifdef PLANE_CHECKER
// The surface lengths (U, V) along the tangent and along normal × tangent, counted in cells.
vec2 planeCells(Plane s, vec3 p) {
#ifdef TURNED_CHECKER
  return vec2(s.startU + dot(s.cellU, p), s.startV + dot(s.cellV, p));
#else
  return vec2(s.startU + s.perCell * p.x, s.startV - s.perCell * p.z);
#endif
}
#endif
