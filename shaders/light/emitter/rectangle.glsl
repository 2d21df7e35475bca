// A rectangle across the z axis as it is seen from the origin: its lowest and highest x and y, and how far away it is.
// Precision: f32; the solid angle is right to a few ulps however small it is, a place on the rectangle to 1e-6 of it where
// the solid angle is above 1/64.
#include "arc-tangent.glsl"

struct Rectangle {
  vec2 low;
  vec2 high;
  float height;
};

float lengthOf(float x, float y, float z) {
  return sqrt(x * x + y * y + z * z);
}

// Its solid angle, as that of two triangles, which does not cancel.
// Source: A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30(2), 1983, equation (8).
float rectangleAngle(Rectangle r) {
  float z2 = r.height * r.height;
  vec2 low2 = r.low * r.low;
  vec2 high2 = r.high * r.high;
  vec2 lowHigh = r.low * r.high;
  float a = lengthOf(r.low.x, r.low.y, r.height);
  float b = lengthOf(r.high.x, r.low.y, r.height);
  float c = lengthOf(r.high.x, r.high.y, r.height);
  float d = lengthOf(r.low.x, r.high.y, r.height);
  float volume = r.height * (r.high.x - r.low.x) * (r.high.y - r.low.y);
  float ab = lowHigh.x + low2.y + z2;
  float bc = high2.x + lowHigh.y + z2;
  float cd = lowHigh.x + high2.y + z2;
  float da = low2.x + lowHigh.y + z2;
  float ac = lowHigh.x + lowHigh.y + z2;
  float first = arcTangent(volume, a * b * c + ab * c + bc * a + ac * b);
  float second = arcTangent(volume, a * c * d + ac * d + cd * a + da * c);
  return 2.0 * (first + second);
}

// The x up to which a part u of the solid angle lies.
float rectangleColumn(Rectangle r, float angle, float u) {
  float z2 = r.height * r.height;
  // Two of the inner angles of the spherical rectangle.
  float atHigh = arcTangent(r.height * lengthOf(r.low.x, r.high.y, r.height), r.high.y * r.low.x);
  float atLow = arcTangent(r.height * lengthOf(r.low.x, r.low.y, r.height), -r.low.y * r.low.x);
  vec2 turn = circle(clamp((u * angle - atHigh - atLow) * 0.159154943 + 1.0, 0.0, 1.0));
  float b0 = -r.low.y / sqrt(z2 + r.low.y * r.low.y);
  float b1 = r.high.y / sqrt(z2 + r.high.y * r.high.y);
  // f = (cos b0 - b1) / sin; x = z sign(f) / sqrt(f² + b0² - 1), both times the sine.
  float f = turn.x * b0 - b1;
  float sine = turn.y * r.height;
  float rest = f * f - sine * sine / (z2 + r.low.y * r.low.y);
  float x = rest > 0.0 ? abs(sine) / sqrt(rest) : MISS;
  float start = clamp(f * turn.y > 0.0 ? x : -x, r.low.x, r.high.x);
  // One step of Newton's method mends what cancelled.
  float beyond = rectangleAngle(Rectangle(r.low, vec2(start, r.high.y), r.height)) - u * angle;
  float across = r.high.y / lengthOf(start, r.high.y, r.height) - r.low.y / lengthOf(start, r.low.y, r.height);
  float density = r.height / (start * start + z2) * across;
  return clamp(start - beyond / max(density, SMALLEST), r.low.x, r.high.x);
}

// A place on it, as parts of both sides, so that all directions are equally likely.
// Source: C. Ureña, M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", CGF 32(4), 2013.
vec2 rectanglePlace(Rectangle r, float angle, vec2 u) {
  float x = rectangleColumn(r, angle, u.x);
  float near2 = x * x + r.height * r.height;
  float h0 = r.low.y / sqrt(near2 + r.low.y * r.low.y);
  float h1 = r.high.y / sqrt(near2 + r.high.y * r.high.y);
  float h = h0 + u.y * (h1 - h0);
  float y = h * sqrt(near2 / max((1.0 - h) * (1.0 + h), SMALLEST));
  return clamp((vec2(x, y) - r.low) / (r.high - r.low), 0.0, 1.0);
}
