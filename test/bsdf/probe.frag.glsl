#version 300 es
// What the BSDF of one material says to many directions and numbers. Each pixel has a question of its own.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "material/bsdf.glsl"

// Rows of: wo and the choice of the lobe; wi and a number; the other number.
uniform sampler2D questions;
// Which answer.
uniform int part;
uniform vec3 color;
uniform float metalness, alpha, f90, eta, transmission, thin;
uniform vec3 f0, specular;

out vec4 answer;

Bsdf material() {
  Bsdf b;
  b.color = color;
#if defined(METAL) && defined(DIELECTRIC)
  b.metalness = metalness;
#endif
#ifdef ROUGH
  b.alpha = alpha;
#endif
#if defined(SPECULAR) && defined(OPAQUE_BASE)
  b.f0 = f0;
#ifdef SPECULAR_WEIGHT
  b.f90 = f90;
#endif
#endif
#ifdef TRANSMISSION
  b.eta = eta;
#ifdef OPAQUE_BASE
  b.transmission = transmission;
#endif
#if defined(SPECULAR_TINT) || defined(SPECULAR_WEIGHT)
  b.specular = specular;
#endif
#if defined(THIN) && defined(SOLID)
  b.thin = thin > 0.0;
#endif
#endif
  return b;
}

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
