// Ray against plane: t = height / -(n·d). The normal points to the camera's side, where all rays are; so the plane is
// met where n·d < 0, and nothing that it could hide is ever lit (see `dimmed` in pack-scene.ts). Level planes, with a
// normal of (0, ±1, 0), get by with a sign.

// What all rays from a point share: its height above the plane.
struct PlaneFrom {
  float height;
};

PlaneFrom planeFrom(Plane s, vec3 o) {
#ifdef TILTED_PLANE
  return PlaneFrom(dot(s.normal, o) - s.offset);
#else
  return PlaneFrom(s.facing * o.y - s.offset);
#endif
}

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(-s.offset);
}

// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
#ifdef TILTED_PLANE
  float approach = -dot(s.normal, d);
#else
  float approach = -s.facing * d.y;
#endif
  return mix(MISS, from.height / approach, min(approach, 0.5 - own) > 0.0);
}

// The unit normal times a weight.
vec3 planeNormal(Plane s, PlaneFrom from, float weight) {
#ifdef TILTED_PLANE
  return weight * s.normal;
#else
  return vec3(0.0, weight * s.facing, 0.0);
#endif
}

#ifdef PLANE_CHECKER
// The surface lengths (U, V) along the tangent and along normal × tangent, counted in cells.
vec2 planeCells(Plane s, vec3 p) {
#ifdef TURNED_CHECKER
  return vec2(dot(s.cellU, p) - s.originU, dot(s.cellV, p) - s.originV);
#else
  return vec2(s.perCell * p.x - s.originU, -s.perCell * p.z - s.originV);
#endif
}
#endif
