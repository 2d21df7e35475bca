// The plane equation, with a fixed offset. A level plane has its normal along y.
const float OFFSET = 1e-4;

struct PlaneFrom {
  vec3 o;
};

PlaneFrom planeFrom(Plane s, vec3 o) {
  return PlaneFrom(o);
}

PlaneFrom planeFromCamera(Plane s) {
  return PlaneFrom(vec3(0.0));
}

vec3 planeDown(Plane s) {
#ifdef TILTED_PLANE
  return s.down;
#else
  return vec3(0.0, s.downY, 0.0);
#endif
}

float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
  vec3 n = planeDown(s);
  float approach = dot(n, d);
  if (abs(approach) < 1e-6) return MISS;
  float t = (s.height - dot(n, from.o)) / approach;
  return t > OFFSET ? t : MISS;
}

vec3 planeNormal(Plane s, PlaneFrom from, vec3 d, float weight) {
  vec3 n = planeDown(s);
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
