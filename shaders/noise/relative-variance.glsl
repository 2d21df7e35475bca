// The variance of a pixel's mean, as the two halves of its samples tell it, over the square of that mean: what is to be
// averaged for the error of a picture (relMSE with ε = 0.01, after exposure).
//
// Let e and o be the means of the even and of the odd samples, a and b = 1 - a their shares. The halves are scrambled
// independently, so E[(e - o)²] = Var e + Var o, and where the variance of a half is σ² over the number of its samples,
// this is σ² / (n a b). So a b (e - o)² is an estimate of σ² / n = Var(a e + b o), without bias: for halves of equal size
// whatever the law by which they converge. It has one degree of freedom for each pixel and channel: its own standard
// deviation is √2 times itself. Over the 3 × 262,144 of a picture of 512 × 512 that is a quarter of a percent where pixels
// are independent, and more where they share their random numbers, as they do along edges.
//
// The mean under it is not known either. m² = (a e + b o)² is too large by v, the variance, and grows with every sample
// that is too bright: the quotient comes out too small. e o is right in the mean, and hardly grows; but it may be near 0 by
// luck: too large. Half-way between the two, m² - v / 2, the errors cancel. Measured on 21 images whose variance per pixel
// is known, with samples drawn by a normal, a gamma and a two-point law of that variance, at 16, 64 and 256 samples:
// estimated over true error is 0.77 to 1.14 with m², 0.95 to 1.79 with e o, 0.83 to 1.19 with this one.
// Smoothing either over neighbours first is worse: 0.97 to 4.4 with 7 × 7 pixels, because noise is next to edges.
#include "accumulated.glsl"

uniform float exposure;

const float EPSILON = 0.01;
// Squares of what is larger would not be numbers.
const float BRIGHTEST = 1e18;

vec3 bounded(vec3 color) {
  return min(mix(vec3(0.0), color, greaterThan(color, vec3(0.0))), BRIGHTEST);
}

// Needs two samples at least.
vec3 relativeVariance(ivec2 pixel, vec4 weight) {
  float a = weight.z;
  float b = 1.0 - a;
  vec3 e = bounded(exposure * (share(even, pixel, weight.x).rgb / a));
  vec3 o = bounded(exposure * (share(odd, pixel, weight.y).rgb / b));
  vec3 difference = e - o;
  vec3 mean = a * e + b * o;
  vec3 variance = a * b * difference * difference;
  return variance / (mean * mean - 0.5 * variance + EPSILON);
}
