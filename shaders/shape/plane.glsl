// Ray against plane: t = height / (down·d), `down` being the unit vector from the camera's side, where all rays are, into
// the plane. So the plane is met where down·d > 0, and nothing that it could hide is ever lit (see `dimmed` in
// pack-scene.ts). Level planes get by with the y component, a sign.

// What all rays from a point share: its height above the plane.
struct PlaneFrom {
  float height;
};

PlaneFrom planeFrom(Plane s, vec3 o) {
#ifdef TILTED_PLANE
  return PlaneFrom(s.height - dot(s.down, o));
#else
  return PlaneFrom(s.height - s.downY * o.y);
#endif
}

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(s.height);
}

// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again: the sign of y
// says so where the plane is level, but where it is tilted rounding may turn a ray that just grazes it.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
#ifdef TILTED_PLANE
  float approach = dot(s.down, d);
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
  return -weight * s.down;
#else
  return vec3(0.0, -weight * s.downY, 0.0);
#endif
}

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
