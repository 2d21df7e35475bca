#version 300 es
// One sample of every pixel by the integrator `path`: linear radiance, premultiplied by the coverage in alpha.
// Precision: f32 throughout.
precision highp float;
precision highp int;

#include "generated/limits.glsl"
#include "generated/scene.glsl"
#include "path.glsl"

out vec4 sampled;

void main() {
  sampled = path();
}
