#version 300 es
// The relative error of each cell of BLOCKS × BLOCKS blocks, from those of the blocks.
precision highp float;
precision highp int;

#include "generated/blocks.glsl"

// From block-error.frag.glsl.
uniform highp sampler2D blocks;
out vec4 measured;

void main() {
  ivec2 size = textureSize(blocks, 0);
  ivec2 corner = BLOCKS * ivec2(gl_FragCoord.xy);
  float sum = 0.0;
  float share = 0.0;
  for (int i = 0; i < BLOCKS * BLOCKS; i++) {
    ivec2 at = corner + ivec2(i % BLOCKS, i / BLOCKS);
    if (at.x < size.x && at.y < size.y) {
      vec2 block = texelFetch(blocks, at, 0).xy;
      sum += block.y * block.x * block.x;
      share += block.y;
    }
  }
  measured = vec4(share > 0.0 ? sqrt(sum / share) : 0.0, share / float(BLOCKS * BLOCKS), 0.0, 0.0);
}
