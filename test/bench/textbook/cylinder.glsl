// The quadratic formula for the side, the plane equation for the caps: P. Heckbert in A. Glassner (ed.), An Introduction to
// Ray Tracing (1989), with a fixed offset.
const float OFFSET = 1e-4;

struct CylinderFrom {
  vec3 o;
};

CylinderFrom cylinderFrom(Cylinder s, vec3 o) {
  return CylinderFrom(o);
}

CylinderFrom cylinderFromCamera(Cylinder s) {
  return CylinderFrom(vec3(0.0));
}

float cylinderCap(Cylinder s, vec3 oc, float along, float dw, float height, vec3 d) {
  float t = (height - along) / dw;
  vec3 q = oc + t * d - height * s.axis;
  return t > OFFSET && dot(q, q) <= s.radius * s.radius ? t : MISS;
}

float cylinderDistance(Cylinder s, CylinderFrom from, vec3 d, float own) {
  vec3 oc = from.o - s.base;
  float dw = dot(d, s.axis);
  float along = dot(oc, s.axis);
  float a = dot(d, d) - dw * dw;
  float b = dot(oc, d) - along * dw;
  float c = dot(oc, oc) - along * along - s.radius * s.radius;
  float discriminant = b * b - a * c;
  if (discriminant < 0.0) return MISS;
  float root = sqrt(discriminant);
  float t = MISS;
  float near = (-b - root) / a;
  float far = (-b + root) / a;
  float nearHeight = along + near * dw;
  float farHeight = along + far * dw;
  if (near > OFFSET && nearHeight >= 0.0 && nearHeight <= s.height) t = near;
  else if (far > OFFSET && farHeight >= 0.0 && farHeight <= s.height) t = far;
  t = min(t, cylinderCap(s, oc, along, dw, 0.0, d));
  return min(t, cylinderCap(s, oc, along, dw, s.height, d));
}

float cylinderOcclusion(Cylinder s, CylinderFrom from, vec3 d, float limit, float own) {
  return limit - cylinderDistance(s, from, d, own);
}

vec3 cylinderNormal(Cylinder s, CylinderFrom from, vec3 d, float weight) {
  vec3 oc = from.o - s.base;
  float along = dot(oc, s.axis);
  vec3 p = oc - along * s.axis;
  bool onCap = max(-along, along - s.height) > length(p) - s.radius;
  vec3 n = onCap ? s.axis : normalize(p);
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
