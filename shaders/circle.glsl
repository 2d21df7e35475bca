// The unit vector at the angle 2 pi u, for u in [0, 1]. Precision: f32 within 1e-7; built-in sines are off by 2e-4 on some
// drivers. Within an eighth of the circle around each half axis, polynomials of least largest error (Remez exchange).
const float INVERSE_PI = 0.31830988618;

vec2 circle(float u) {
  float quarter = floor(4.0 * u + 0.5);
  float f = 4.0 * u - quarter;
  float t = f * f;
  float x = 1.0 + t * (-1.23370054351 + t * (0.253669247229 + t * (-0.0208603085029 + t * 0.000904060569983)));
  float y = f * (1.57079632501 + t * (-0.645963434607 + t * (0.0796793781314 - t * 0.00459959170717)));
  vec2 turned = quarter == 1.0 || quarter == 3.0 ? vec2(-y, x) : vec2(x, y);
  return quarter == 2.0 || quarter == 3.0 ? -turned : turned;
}
