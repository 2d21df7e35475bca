// Two unit vectors x and y that make a right-handed frame with the unit normal n as its z.
// Source: T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017. There it changes over at n.z = 0;
// here it does at a normal that no floor, wall or roof has, so that f32 and f64 go the same way. Precision: f32; the sum
// that is divided by is 0.38 or more.
void tangents(vec3 n, out vec3 x, out vec3 y) {
  float side = n.z > -0.6180339887 ? 1.0 : -1.0;
  float a = -1.0 / (side + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
  y = vec3(b, side + n.y * n.y * a, -n.y);
}
