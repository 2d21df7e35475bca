// Ray against plane: t = height / (down·d), `down` being the unit vector from the camera's side, where all rays are, into
// the plane. So the plane is met where down·d > 0, and nothing that it could hide is ever lit (see `dimmed` in
// pack-scene.ts). Level planes get by with the y component, a sign; for others see plane-tilted.glsl. Precision: f32.

// What all rays from a point share: its height above the plane.
struct PlaneFrom {
  float height;
};

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(s.height);
}

#ifdef TILTED_PLANE
#include "shape/plane-tilted.glsl"
#else
PlaneFrom planeFrom(Plane s, vec3 o) {
  return PlaneFrom(s.height - s.downY * o.y);
}
#endif

#if defined(THROUGH)
#include "shape/plane-through.glsl"
#elif !defined(TILTED_PLANE)
// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again: the sign of y
// says so.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
  float approach = s.downY * d.y;
  return mix(MISS, from.height / approach, approach > 0.0);
}

// The unit normal times a weight.
vec3 planeNormal(Plane s, PlaneFrom from, vec3 d, float weight) {
  return vec3(0.0, -weight * s.downY, 0.0);
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
