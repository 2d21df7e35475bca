// The angle of the point (x, y) in (-pi, pi], to 2e-7: the built-in atan is off by up to 4e-6 on some drivers.
// Source: S. Moshier, Cephes library, atanf: a polynomial on |t| <= tan(pi / 8), and reflections to get there. Precision: f32.
float arcTangent(float y, float x) {
  vec2 a = abs(vec2(x, y));
  float t = min(a.x, a.y) / max(max(a.x, a.y), SMALLEST);
  float steep = step(0.41421356, t);
  t = mix(t, (t - 1.0) / (t + 1.0), steep);
  float t2 = t * t;
  float series = ((8.05374449538e-2 * t2 - 1.38776856032e-1) * t2 + 1.99777106478e-1) * t2 - 3.33329491539e-1;
  float angle = series * t2 * t + t + steep * 0.785398163;
  angle = mix(angle, 1.57079633 - angle, a.y > a.x);
  angle = mix(angle, 3.14159265 - angle, x < 0.0);
  return mix(angle, -angle, y < 0.0);
}
