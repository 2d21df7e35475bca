// 1 where floor(U) + floor(V) is odd, else 0, for lengths counted in cells. Precision: exact up to 2^24 cells, the whole
// numbers of f32.
#ifdef CHECKER
float checkerOdd(vec2 cells) {
  return 2.0 * fract(0.5 * (floor(cells.x) + floor(cells.y)));
}
#endif
