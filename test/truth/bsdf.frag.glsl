#version 300 es
// What the functions of BSDFs say to given numbers. CALL is put in by bsdf-probe.ts.
precision highp float;
precision highp int;

#include "probe/material.glsl"

uniform vec3 first;
uniform vec3 second;

out vec4 answer;

void main() {
  Bsdf b = material();
  CALL;
}
