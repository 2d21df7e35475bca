#version 300 es
// One triangle over the whole view, which hands the scene's numbers on to the fragment shader: software rasterisers read
// a uniform at the price of ten operations, a flat varying at that of two. The camera ray is interpolated, exactly but
// for rounding, since it is linear in the window; where rounding matters, every fragment works it out.
precision highp float;

#ifdef VARYINGS
#include "generated/view.glsl"
#endif
#include "generated/rows.glsl"

#ifdef VARYINGS
out vec3 ray;
#endif

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
#ifdef VARYINGS
  ray = eye.corner + (corner.x * eye.width) * eye.stepX + (corner.y * eye.height) * eye.stepY;
#endif
  passRows();
}
