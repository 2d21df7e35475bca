#version 300 es
// Shows accumulated samples: their mean, exposed, tone mapped and encoded, premultiplied as a page composites it.
precision highp float;

#include "accumulated.glsl"
#include "display/srgb.glsl"
#ifdef TONE_MAPPING_NEUTRAL
#include "display/pbr-neutral.glsl"
#endif

uniform float exposure;
out vec4 shown;

// Beyond any white, and so far from the end of f32 that nothing below can overflow.
const float BRIGHTEST = 1e30;

// Into [0, BRIGHTEST], NaN to 0. By comparison, because what max() does with NaN differs between drivers.
vec3 finite(vec3 color) {
  return min(mix(vec3(0.0), color, greaterThan(color, vec3(0.0))), BRIGHTEST);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 weight = weightsAt(pixel);
  vec4 mean = share(even, pixel, weight.x) + share(odd, pixel, weight.y);
  // Curves need the colour of what covers the pixel, not that colour's share of it: both are set right again below.
  vec3 color = mean.a > 0.0 ? mean.rgb / mean.a : vec3(0.0);
  color = finite(exposure * finite(color));
#ifdef TONE_MAPPING_NEUTRAL
  color = toneMapNeutral(color);
#endif
  float alpha = min(mean.a, 1.0);
  shown = vec4(alpha * encodeSrgb(min(color, 1.0)), alpha);
}
