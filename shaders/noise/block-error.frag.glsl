#version 300 es
// The relative error of each block of BLOCK × BLOCK pixels: the root of the mean of the relative variances of its pixels
// and channels. A root, because half floats hold roots of what they could not hold.
precision highp float;
precision highp int;

#include "generated/blocks.glsl"
#include "noise/relative-variance.glsl"

// Error; share of the block that is in the picture and has samples enough.
out vec4 measured;

void main() {
  ivec2 size = textureSize(even, 0);
  ivec2 corner = BLOCK * ivec2(gl_FragCoord.xy);
  float sum = 0.0;
  float count = 0.0;
  for (int i = 0; i < BLOCK * BLOCK; i++) {
    ivec2 pixel = corner + ivec2(i % BLOCK, i / BLOCK);
    vec4 weight = weightsAt(pixel);
    if (pixel.x < size.x && pixel.y < size.y && weight.w > 1.5) {
      vec3 variance = relativeVariance(pixel, weight);
      sum += (variance.r + variance.g + variance.b) / 3.0;
      count += 1.0;
    }
  }
  measured = vec4(sqrt(sum / max(count, 1.0)), count / float(BLOCK * BLOCK), 0.0, 0.0);
}
