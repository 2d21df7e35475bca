#ifdef CHECKER
// 1 where floor(U) + floor(V) is odd, else 0, for lengths counted in cells.
float checkerOdd(vec2 cells) {
  return 2.0 * fract(0.5 * (floor(cells.x) + floor(cells.y)));
}
#endif
