// Ray against plane: t = height / -(n·d). The normal points to the camera's side, where all rays are; so the plane is
// met where n·d < 0, and nothing that it could hide is ever lit (see `dimmed` in pack-scene.ts).

// What all rays from a point share: its height above the plane.
struct PlaneFrom {
  float height;
};

PlaneFrom planeFrom(Plane s, vec3 o) {
  return PlaneFrom(dot(s.normal, o) - s.offset);
}

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(-s.offset);
}

// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
  float approach = -dot(s.normal, d);
  return mix(MISS, from.height / approach, min(approach, 0.5 - own) > 0.0);
}

vec3 planeNormal(Plane s, PlaneFrom from) {
  return s.normal;
}

#ifdef PLANE_CHECKER
// The surface lengths (U, V) along the tangent and along normal × tangent, counted in cells.
vec2 planeCells(Plane s, vec3 p) {
  return vec2(dot(s.cellU, p) - s.originU, dot(s.cellV, p) - s.originV);
}
#endif
