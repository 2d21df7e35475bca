#version 300 es
// Shows how many samples each pixel has: bright where there are most, dark where there are none.
precision highp float;
precision highp int;

#include "accumulated.glsl"
#include "display/ramp.glsl"

uniform float most;
out vec4 shown;

void main() {
  shown = vec4(ramp(weightsAt(ivec2(gl_FragCoord.xy)).w / most), 1.0);
}
