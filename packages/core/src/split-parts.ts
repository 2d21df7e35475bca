/** Vectors packed in three parts, for `splitDot` of shaders/split-dot.glsl. */
import type { Vec3 } from './vector.ts';

/** The parts of a vector of length at most 1: 11 bits after the point, the next 11, and the rest. They add up to it. */
export function splitParts(v: Vec3): readonly [Vec3, Vec3, Vec3] {
  const first = rounded(v, 2 ** 11);
  const second = rounded(difference(v, first), 2 ** 22);
  return [first, second, difference(difference(v, first), second)];
}

const rounded = (v: Vec3, steps: number): Vec3 => v.map((x) => Math.round(x * steps) / steps) as unknown as Vec3;

const difference = (a: Vec3, b: Vec3): Vec3 => a.map((x, i) => x - (b[i] as number)) as unknown as Vec3;
