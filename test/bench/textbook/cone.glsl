// The quadratic formula for the double cone, its wrong half and what is beyond the base left out, and the plane equation for
// the base: P. Heckbert in A. Glassner (ed.), An Introduction to Ray Tracing (1989), with a fixed offset.
const float OFFSET = 1e-4;

struct ConeFrom {
  vec3 o;
};

ConeFrom coneFrom(Cone s, vec3 o) {
  return ConeFrom(o);
}

ConeFrom coneFromCamera(Cone s) {
  return ConeFrom(vec3(0.0));
}

float coneDistance(Cone s, ConeFrom from, vec3 d, float own) {
  vec3 oc = from.o - s.tip;
  float dw = dot(d, s.axis);
  float along = dot(oc, s.axis);
  float stretch = 1.0 + s.slope * s.slope;
  float a = dot(d, d) - stretch * dw * dw;
  float b = dot(oc, d) - stretch * along * dw;
  float c = dot(oc, oc) - stretch * along * along;
  float discriminant = b * b - a * c;
  if (discriminant < 0.0) return MISS;
  float root = sqrt(discriminant);
  float one = (-b - root) / a;
  float other = (-b + root) / a;
  float near = min(one, other);
  float far = max(one, other);
  float nearHeight = along + near * dw;
  float farHeight = along + far * dw;
  float t = MISS;
  if (near > OFFSET && nearHeight >= 0.0 && nearHeight <= s.height) t = near;
  else if (far > OFFSET && farHeight >= 0.0 && farHeight <= s.height) t = far;
  float base = (s.height - along) / dw;
  vec3 q = oc + base * d - s.height * s.axis;
  float radius = s.slope * s.height;
  return base > OFFSET && dot(q, q) <= radius * radius ? min(t, base) : t;
}

float coneOcclusion(Cone s, ConeFrom from, vec3 d, float limit, float own) {
  return limit - coneDistance(s, from, d, own);
}

vec3 coneNormal(Cone s, ConeFrom from, vec3 d, float weight) {
  vec3 oc = from.o - s.tip;
  float along = dot(oc, s.axis);
  vec3 p = oc - along * s.axis;
  bool onBase = (along - s.height) * sqrt(1.0 + s.slope * s.slope) > length(p) - s.slope * along;
  vec3 n = onBase ? s.axis : normalize(normalize(p) - s.slope * s.axis);
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
