#version 300 es
// One triangle over the whole viewport, from the vertex numbers alone: (-1, -1), (3, -1), (-1, 3). Precision: exact.

void main() {
  gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 2.0 * float(gl_VertexID & 2) - 1.0, 0.0, 1.0);
}
