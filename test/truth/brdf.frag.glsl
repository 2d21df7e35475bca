#version 300 es
// What the functions of light say to given numbers. CALL is put in by brdf-probe.ts.
precision highp float;
precision highp int;

#include "generated/limits.glsl"
#include "generated/scene.glsl"
#include "direct.glsl"

uniform vec3 numbers;
uniform vec3 vector;

out vec4 answer;

void main() {
  CALL;
}
