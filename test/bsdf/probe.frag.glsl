#version 300 es
// What the BSDF of one material says to many directions and numbers. Each pixel has a question of its own.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "probe/material.glsl"

// Rows of: wo and the choice of the lobe; wi and a number; the other number.
uniform sampler2D questions;
// Which answer.
uniform int part;

out vec4 answer;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 first = texelFetch(questions, ivec2(at.x, 3 * at.y), 0);
  vec4 second = texelFetch(questions, ivec2(at.x, 3 * at.y + 1), 0);
  vec4 third = texelFetch(questions, ivec2(at.x, 3 * at.y + 2), 0);
  Bsdf b = material();
  if (part < 2) {
    BsdfSample drawn = bsdfSample(b, first.xyz, vec2(second.w, third.x), first.w);
    answer = part == 0 ? vec4(drawn.wi, drawn.pdf) : vec4(drawn.weight, isMirrorOnly(b) ? 1.0 : 0.0);
  } else {
    float pdf;
    vec3 value = bsdfValue(b, first.xyz, second.xyz, pdf);
    answer = vec4(value, pdf);
  }
}
