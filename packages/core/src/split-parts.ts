/** Vectors packed in parts that hold so few bits that sums and products of them are exact in f32. */
import { rounded, subtract, type Vec3 } from './vector.ts';

/**
 * The parts of a vector of length at most 1, for `splitDot` of shaders/split-dot.glsl: 11 bits after the point, the next
 * 11, and the rest. They add up to it.
 */
export function splitParts(v: Vec3): readonly [Vec3, Vec3, Vec3] {
  const first = rounded(v, 11);
  const rest = subtract(v, first);
  const second = rounded(rest, 22);
  return [first, second, subtract(rest, second)];
}
