// Directions at a surface, in its own frame: two tangents, and the normal as z. Precision: f32, sums in this order.
#include "split-dot.glsl"
#include "tangents.glsl"

mat3 surfaceFrame(vec3 n) {
  mat3 frame;
  tangents(n, frame[0], frame[1]);
  frame[2] = n;
  return frame;
}

vec3 toLocal(mat3 frame, vec3 v) {
  return vec3(dotInOrder(frame[0], v), dotInOrder(frame[1], v), dotInOrder(frame[2], v));
}

vec3 toWorld(mat3 frame, vec3 v) {
  return v.x * frame[0] + v.y * frame[1] + v.z * frame[2];
}
