// Ray against plane where rays pass through surfaces: from either side. See plane.glsl. Precision: f32.

float planeApproach(Plane s, vec3 d) {
#ifdef TILTED_PLANE
  return planeDescent(s, d);
#else
  return s.downY * d.y;
#endif
}

// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again, nor does one that
// runs along it.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
  float t = from.height / planeApproach(s, d);
  return mix(MISS, t, t > 0.0 && t < MISS && own < 0.5);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float planeOcclusion(Plane s, PlaneFrom from, vec3 d, float limit, float own) {
  return limit - planeDistance(s, from, d, own);
}
#endif

// The unit normal on the side that d comes from, times a weight.
vec3 planeNormal(Plane s, PlaneFrom from, vec3 d, float weight) {
  float facing = planeApproach(s, d) > 0.0 ? -weight : weight;
#ifdef TILTED_PLANE
  return facing * planeDown(s);
#else
  return vec3(0.0, facing * s.downY, 0.0);
#endif
}

#ifdef SIDES
// Whether the ray comes from the side that the normal points to: `down` leads away from the camera's.
bool planeFront(Plane s, PlaneFrom from, vec3 d) {
  return (planeApproach(s, d) > 0.0) == (s.cameraSide > 0.0);
}
#endif
