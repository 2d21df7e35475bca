#version 300 es
// One sample of every pixel by the integrator `path`: linear radiance, premultiplied by the coverage in alpha; or what
// `output` shows in its place.
// Precision: f32 throughout.
precision highp float;
precision highp int;

#include "generated/limits.glsl"
#include "generated/scene.glsl"
#if defined(NORMAL) || defined(DEPTH) || defined(ALBEDO)
#include "output.glsl"
#else
#include "path.glsl"
#endif

out vec4 sampled;

void main() {
#if defined(NORMAL) || defined(DEPTH) || defined(ALBEDO)
  sampled = firstSurface();
#else
  sampled = path();
#endif
}
