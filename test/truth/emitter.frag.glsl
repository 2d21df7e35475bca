#version 300 es
// What the functions of lights say to the numbers of one column of `asked`, in four rows of the answer.
precision highp float;
precision highp int;

#include "constants.glsl"
#include "generated/scene.glsl"
#include "light/emitters.glsl"

// Rows: p and which; u, own, and the emitter whose pdf is asked for; the direction of that, and t; the cosine.
uniform highp sampler2D asked;

out vec4 answer;

vec4 row(int i) {
  return texelFetch(asked, ivec2(int(gl_FragCoord.x), i), 0);
}

void main() {
  int part = int(gl_FragCoord.y);
  int own = int(row(1).z);
  EmitterSample s = sampleEmitter(row(0).xyz, row(0).w, row(1).xy, own);
  if (part == 0) answer = vec4(s.direction, s.distance);
  if (part == 1) answer = vec4(s.radiance, s.pdf);
  if (part == 2) answer = vec4(s.delta ? 1.0 : 0.0, float(s.object), 0.0, 0.0);
  if (part == 3) {
    int emitter = int(row(1).w);
#ifdef AREA_EMITTER
    float pdf = emitterPdf(emitter, row(0).xyz, row(2).xyz, row(2).w, row(3).x, own);
    answer = vec4(pdf, emitterRadiance(emitter, row(2).xyz));
#else
    // No ray meets what has no extent.
    answer = vec4(0.0, emitters[emitter].strength);
#endif
  }
}
