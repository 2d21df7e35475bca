/**
 * gl-matrix in f64 and by value. Its own `create()` makes Float32Arrays (unless a page changed its global array
 * type, which is not ours to touch), so every result here is a fresh array of plain numbers.
 */
import { vec3 } from 'gl-matrix';

/** Three coordinates or three linear colour channels. */
export type Vec3 = readonly [number, number, number];

type Fresh = [number, number, number];

export const add = (a: Vec3, b: Vec3): Vec3 => vec3.add([0, 0, 0], a, b) as Fresh;
export const subtract = (a: Vec3, b: Vec3): Vec3 => vec3.subtract([0, 0, 0], a, b) as Fresh;
export const multiply = (a: Vec3, b: Vec3): Vec3 => vec3.multiply([0, 0, 0], a, b) as Fresh;
export const scale = (a: Vec3, factor: number): Vec3 => vec3.scale([0, 0, 0], a, factor) as Fresh;
/** a + factor b */
export const addScaled = (a: Vec3, b: Vec3, factor: number): Vec3 => vec3.scaleAndAdd([0, 0, 0], a, b, factor) as Fresh;
export const cross = (a: Vec3, b: Vec3): Vec3 => vec3.cross([0, 0, 0], a, b) as Fresh;
export const dot = (a: Vec3, b: Vec3): number => vec3.dot(a, b);
/** Exact at both ends: a where t is 0, b where it is 1. */
export const mix = (a: Vec3, b: Vec3, t: number): Vec3 => addScaled(scale(a, 1 - t), b, t);
export const negate = (a: Vec3): Vec3 => vec3.negate([0, 0, 0], a) as Fresh;

/** Euclidean length, right even where the squares leave the range of f64; `hypot` takes five times as long. */
export function length(a: Vec3): number {
  const square = dot(a, a);
  return square > 1e-280 && square < 1e280 ? Math.sqrt(square) : Math.hypot(...a);
}

/** The unit vector along a; a vector of zeros stays as it is. */
export function normalize(a: Vec3): Vec3 {
  const size = length(a);
  return size > 0 ? [a[0] / size, a[1] / size, a[2] / size] : a;
}

/** Components with so many bits after the point. */
export const rounded = (v: Vec3, bits: number): Vec3 =>
  v.map((x) => Math.round(x * 2 ** bits) / 2 ** bits) as unknown as Vec3;
