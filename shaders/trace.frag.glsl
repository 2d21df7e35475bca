#version 300 es
// One sample of every pixel: linear radiance, premultiplied by the coverage in alpha. The samples are added up in a
// float target by blending. Precision: f32 throughout.
precision highp float;
precision highp int;

#include "generated/limits.glsl"
#include "generated/scene.glsl"
#include "camera.glsl"
#include "direct.glsl"

out vec4 sampled;

void main() {
  sampled = direct(cameraRay());
}
