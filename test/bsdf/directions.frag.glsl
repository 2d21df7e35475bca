#version 300 es
// Unit normals from all around, what `tangents` makes of them, and `circle` at even steps.
precision highp float;
precision highp int;

#include "circle.glsl"
#include "tangents.glsl"

uniform int part;

out vec4 answer;

void main() {
  float number = floor(gl_FragCoord.x) + 256.0 * floor(gl_FragCoord.y);
  // A spiral from pole to pole; the middle third of it stays close to where tangents change over.
  float height = -1.0 + 2.0 * number / 65535.0;
  float z = abs(height) < 0.3 ? -0.6180339887 + 1e-6 * height : height;
  vec2 around = circle(fract(number * 0.618034));
  vec3 n = vec3(sqrt(1.0 - z * z) * around, z);
  n /= sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  vec3 x;
  vec3 y;
  tangents(n, x, y);
  if (part == 0) answer = vec4(n, 0.0);
  else if (part == 1) answer = vec4(x, 0.0);
  else if (part == 2) answer = vec4(y, 0.0);
  else answer = vec4(circle(number / 65536.0), 0.0, 0.0);
}
