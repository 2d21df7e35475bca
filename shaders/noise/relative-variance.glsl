// The variance of a pixel's mean, as the two halves of its samples tell it, over the square of that mean: what is to be
// averaged for the error of a picture (relMSE with ε = 0.01, after exposure).
//
// Let e and o be the means of the even and of the odd samples, a and b = 1 - a their shares. The halves are scrambled
// independently, so E[(e - o)²] = Var e + Var o, and where the variance of a half is σ² over the number of its samples,
// this is σ² / (n a b). So a b (e - o)² is an estimate of σ² / n = Var(a e + b o), without bias: for halves of equal size
// whatever the law by which they converge. It has one degree of freedom for each pixel and channel: its own standard
// deviation is √2 times itself. Over the 3 × 262,144 of a picture of 512 × 512 that is a quarter of a percent where pixels
// are independent, and more where they share their random numbers, as they do along edges by `direct`.
//
// The mean under it is not known either, and a sample that is too bright makes both larger, so that their quotient would be
// hardly 4, however rare and bright it was. What the eight neighbours have in the mean knows nothing of that sample. But it
// may be beyond an edge: so it counts only as far as it lies between the mean of the pixel's darker half, in which that
// sample is not, and that of the pixel itself. That errs on the safe side, by half of what it tells: 4 % are said to be
// 4.08 %.
//
// Where the neighbours are brighter than either half, the pixel may be at the edge of a lamp, and nobody knows how much of
// it is the lamp's. In pixels of which a lamp has less than one sample stands for, most pictures meet nothing of it: they
// tell no variance where the relative one is largest. The pixels in which one sample has met it have to stand for them. Let
// d be the mean of the darker half and A that of all samples. If all shares are as likely, the mean m of pixels like this
// one is anything from d to A, and what they add up to is that variance times the integral of m / (m² + ε) over m, which is
// ln((A² + ε) / (d² + ε)) / 2, over the square of A. Along the edge of a lamp 15 or 100 times as bright as white in the
// dark, 16 samples tell 1.2 and 1.3 of the noise that they have; without this, 0.9 and 0.8 (noise.test.ts).
//
// docs/what-accuracy-costs.md tells how it is in all examples. With four neighbours, 16 samples of a caustic under a glass
// ball would tell a tenth more.
// Precision: f32; what may leave the range of half floats is told by its root.
#include "accumulated.glsl"

uniform float exposure;

const float EPSILON = 0.01;
// Squares of what is larger would not be numbers.
const float BRIGHTEST = 1e18;
// Of one pixel. Half floats hold the root of it.
const float MOST = 1e9;

vec3 bounded(vec3 color) {
  return min(mix(vec3(0.0), color, greaterThan(color, vec3(0.0))), BRIGHTEST);
}

// The means of the two halves and of all samples.
struct Means {
  vec3 even;
  vec3 odd;
  vec3 all;
};

Means meansAt(ivec2 pixel, vec4 weight) {
  float a = weight.z;
  float b = 1.0 - a;
  vec3 e = bounded(exposure * (share(even, pixel, weight.x).rgb / a));
  vec3 o = bounded(exposure * (share(odd, pixel, weight.y).rgb / b));
  return Means(e, o, a * e + b * o);
}

// The mean around a pixel; beyond the edge of the picture, and where there are too few samples, stands the pixel itself.
vec3 neighbours(ivec2 pixel, vec3 own) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 9; i++) {
    if (i == 4) continue;
    ivec2 at = pixel + ivec2(i % 3, i / 3) - 1;
    bool isIn = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(even, 0)));
    vec4 weight = isIn ? weightsAt(at) : vec4(0.0);
    sum += weight.w > 1.5 ? meansAt(at, weight).all : own;
  }
  return 0.125 * sum;
}

// Needs two samples at least.
vec3 relativeVariance(ivec2 pixel, vec4 weight) {
  Means means = meansAt(pixel, weight);
  vec3 difference = means.even - means.odd;
  vec3 variance = weight.z * (1.0 - weight.z) * difference * difference;
  vec3 darker = min(means.even, means.odd);
  vec3 around = neighbours(pixel, means.all);
  vec3 mean = clamp(around, darker, means.all);
  vec3 square = mean * mean + EPSILON;
  bvec3 isEdge = greaterThan(around, max(means.even, means.odd));
  vec3 stands = max(vec3(1.0), 0.5 * log(square / (darker * darker + EPSILON)));
  return min(mix(vec3(1.0), stands, isEdge) * variance / square, MOST);
}
