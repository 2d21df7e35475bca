// The samples that a picture has so far: linear radiance premultiplied by coverage, those with even and those with odd
// numbers apart. Each half is the sum of its samples, or their mean where targets are of half floats. Precision: that of the
// targets.
#include "generated/cells.glsl"

uniform highp sampler2D even;
uniform highp sampler2D odd;
// A texel for every cell of 2^CELL_BITS × 2^CELL_BITS pixels: what the halves are to be multiplied by to add up to the mean of all
// samples, the even ones' share of the samples, and how many there are. 0: none yet, and the halves hold anything.
uniform highp sampler2D weights;

vec4 weightsAt(ivec2 pixel) {
  return texelFetch(weights, pixel >> CELL_BITS, 0);
}

// What a half adds to the mean.
vec4 share(highp sampler2D samples, ivec2 pixel, float weight) {
  return weight > 0.0 ? weight * texelFetch(samples, pixel, 0) : vec4(0.0);
}
