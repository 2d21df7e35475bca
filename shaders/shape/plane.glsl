// Ray against plane: t = (h - n·o) / (n·d), with h the offset of the plane from the camera, rounded from f64.

// The distance t > 0, or MISS. A ray that leaves the plane itself never meets it again.
float planeDistance(Plane s, vec3 o, vec3 d, bool own) {
  float t = (s.offset - dot(s.normal, o)) / dot(s.normal, d);
  return t > 0.0 && !own ? t : MISS;
}

vec3 planeNormal(Plane s, vec3 p) {
  return s.normal;
}
