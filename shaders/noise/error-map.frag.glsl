#version 300 es
// Shows the relative error around each pixel: dark where it is 0.1 % or less, bright where it is all of the light or more,
// a third of the ramp for each power of ten between. The squares of the errors of the blocks are interpolated, so that
// each pixel shows the mean over 64 around it: 192 degrees of freedom, good for 10 % of the variance.
precision highp float;
precision highp int;

#include "generated/blocks.glsl"
#include "display/ramp.glsl"

// From block-error.frag.glsl.
uniform highp sampler2D blocks;
out vec4 shown;

const float LEAST = 1e-3;
const float DECADES = 3.0;

// The square of a block's error times what of it has one, and that share.
vec2 blockAt(ivec2 at) {
  vec2 block = texelFetch(blocks, clamp(at, ivec2(0), textureSize(blocks, 0) - 1), 0).xy;
  return vec2(block.y * block.x * block.x, block.y);
}

void main() {
  vec2 at = gl_FragCoord.xy / float(BLOCK) - 0.5;
  vec2 corner = floor(at);
  vec2 within = at - corner;
  ivec2 i = ivec2(corner);
  vec2 lower = mix(blockAt(i), blockAt(i + ivec2(1, 0)), within.x);
  vec2 upper = mix(blockAt(i + ivec2(0, 1)), blockAt(i + ivec2(1, 1)), within.x);
  vec2 block = mix(lower, upper, within.y);
  float error = block.y > 0.0 ? sqrt(block.x / block.y) : 0.0;
  float decades = log2(max(error, LEAST) / LEAST) / log2(10.0);
  shown = vec4(ramp(min(decades / DECADES, 1.0)), 1.0);
}
