// The quartic, solved in closed form by way of its resolvent cubic (Ferrari), as shader collections have it: I. Quilez,
// "Torus - intersection" (2014), with a fixed offset. In ring units.
const float OFFSET = 1e-4;

struct TorusFrom {
  vec3 o;
};

TorusFrom torusFrom(Torus s, vec3 o) {
  return TorusFrom(s.unit * (o - s.center));
}

TorusFrom torusFromCamera(Torus s) {
  return TorusFrom(-s.unit * s.center);
}

float torusDistance(Torus s, TorusFrom from, vec3 d, float own) {
  float ring2 = s.radius * s.radius;
  float m = dot(from.o, from.o);
  float n = dot(from.o, d);
  float k = (m - s.tube * s.tube - ring2) / 2.0;
  float climb = dot(d, s.axis);
  float height = dot(from.o, s.axis);
  float k3 = n;
  float k2 = n * n + ring2 * climb * climb + k;
  float k1 = k * n + ring2 * height * climb;
  float k0 = k * k + ring2 * height * height - ring2 * s.tube * s.tube;
  float flip = 1.0;
  if (abs(k3 * (k3 * k3 - k2) + k1) < 0.01) {
    flip = -1.0;
    float swapped = k1;
    k1 = k3;
    k3 = swapped;
    k0 = 1.0 / k0;
    k1 *= k0;
    k2 *= k0;
    k3 *= k0;
  }
  float c2 = (2.0 * k2 - 3.0 * k3 * k3) / 3.0;
  float c1 = 2.0 * (k3 * (k3 * k3 - k2) + k1);
  float c0 = (k3 * (k3 * (-3.0 * k3 * k3 + 4.0 * k2) - 8.0 * k1) + 4.0 * k0) / 3.0;
  float q = c2 * c2 + c0;
  float r = 3.0 * c0 * c2 - c2 * c2 * c2 - c1 * c1;
  float h = r * r - q * q * q;
  float z;
  if (h < 0.0) {
    float root = sqrt(q);
    z = 2.0 * root * cos(acos(r / (root * q)) / 3.0);
  } else {
    float root = pow(sqrt(h) + abs(r), 1.0 / 3.0);
    z = sign(r) * abs(root + q / root);
  }
  z = c2 - z;
  float d1 = z - 3.0 * c2;
  float d2 = z * z - 3.0 * c0;
  if (abs(d1) < 1e-4) {
    if (d2 < 0.0) return MISS;
    d2 = sqrt(d2);
  } else {
    if (d1 < 0.0) return MISS;
    d1 = sqrt(d1 / 2.0);
    d2 = c1 / d1;
  }
  float t = MISS;
  float first = d1 * d1 - z + d2;
  if (first > 0.0) {
    first = sqrt(first);
    float a = -d1 - first - k3;
    float b = -d1 + first - k3;
    a = flip < 0.0 ? 2.0 / a : a;
    b = flip < 0.0 ? 2.0 / b : b;
    if (a > OFFSET) t = a;
    if (b > OFFSET) t = min(t, b);
  }
  float second = d1 * d1 - z - d2;
  if (second > 0.0) {
    second = sqrt(second);
    float a = d1 - second - k3;
    float b = d1 + second - k3;
    a = flip < 0.0 ? 2.0 / a : a;
    b = flip < 0.0 ? 2.0 / b : b;
    if (a > OFFSET) t = min(t, a);
    if (b > OFFSET) t = min(t, b);
  }
  return t < MISS ? t / s.unit : MISS;
}

float torusOcclusion(Torus s, TorusFrom from, vec3 d, float limit, float own) {
  return limit - torusDistance(s, from, d, own);
}

vec3 torusNormal(Torus s, TorusFrom from, vec3 d, float weight) {
  float height = dot(from.o, s.axis);
  vec3 level = from.o - height * s.axis;
  vec3 n = normalize(from.o - s.radius * normalize(level));
  return weight * (dot(n, d) > 0.0 ? -n : n);
}
