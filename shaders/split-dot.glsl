// Dot products whose bits matter: built-in `dot` adds up in an order that differs between drivers.
// Precision: f32, and `splitDot` almost twice that.

float dotInOrder(vec3 a, vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

#ifdef WIDE_RANGE
// n·d to almost twice the precision of f32, for |n| <= 1 packed in three parts (see split-parts.ts) and |d| <= 1: for a ray
// along a surface so large that all that is left of n·d is what f32 would have rounded away.
// n1 and d1 hold 11 bits after the point, so that their products and the sum of these are exact; n2 and d2 hold the next 11,
// n3 and d3 the rest. There are no sums with an error term, which compilers take apart.
float splitDot(vec3 n1, vec3 n2, vec3 n3, vec3 d) {
  vec3 d1 = floor(d * 2048.0 + 0.5) / 2048.0;
  vec3 rest = d - d1;
  vec3 d2 = floor(rest * 4194304.0 + 0.5) / 4194304.0;
  vec3 d3 = rest - d2;
  float middle = dotInOrder(n1, d2) + dotInOrder(n2, d1);
  return (dotInOrder(n1, d1) + middle) + (dotInOrder(n2, rest) + (dotInOrder(n1, d3) + dotInOrder(n3, d)));
}
#endif
