/** Arithmetic in f32: every operation rounds. */
import type { Vec3 } from '@ray-scene/core';

const f = Math.fround;

/** From left to right. */
export const sum = (...terms: readonly number[]): number => terms.reduce((total, term) => f(total + term));
/** From left to right. */
export const product = (...factors: readonly number[]): number => factors.reduce((total, factor) => f(total * factor));
export const difference = (a: number, b: number): number => f(a - b);
export const quotient = (a: number, b: number): number => f(a / b);
export const root = (a: number): number => f(Math.sqrt(a));

export const subtract = (a: Vec3, b: Vec3): Vec3 => [f(a[0] - b[0]), f(a[1] - b[1]), f(a[2] - b[2])];

/** a + t b */
export const addScaled = (a: Vec3, b: Vec3, t: number): Vec3 => [
  f(a[0] + f(t * b[0])),
  f(a[1] + f(t * b[1])),
  f(a[2] + f(t * b[2])),
];

export const scale = (a: Vec3, factor: number): Vec3 => [f(a[0] * factor), f(a[1] * factor), f(a[2] * factor)];

export const dot = (a: Vec3, b: Vec3): number => f(f(f(a[0] * b[0]) + f(a[1] * b[1])) + f(a[2] * b[2]));

export const cross = (a: Vec3, b: Vec3): Vec3 => [
  f(f(a[1] * b[2]) - f(a[2] * b[1])),
  f(f(a[2] * b[0]) - f(a[0] * b[2])),
  f(f(a[0] * b[1]) - f(a[1] * b[0])),
];

export const normalize = (a: Vec3): Vec3 => {
  const size = root(dot(a, a));
  return [f(a[0] / size), f(a[1] / size), f(a[2] / size)];
};
