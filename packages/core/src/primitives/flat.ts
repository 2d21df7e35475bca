/** What the flat shapes have in common: the plane they lie in, and the pattern on it. */
import { type Frame, toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { cross, dot, type Vec3 } from '../vector.ts';
import { withinPair } from './plane.ts';

/** Members of a record for the pattern of a kind: U and V counted in cells are linear in the place. */
export const cellMembers = <const K extends string>(kind: K) =>
  [
    { name: 'cellU', type: 'vec3', when: `${kind}Checker` },
    { name: 'startU', type: 'float', when: `${kind}Checker` },
    { name: 'cellV', type: 'vec3', when: `${kind}Checker` },
    { name: 'startV', type: 'float', when: `${kind}Checker` },
  ] as const;

/** The values of `cellMembers`: `u` and `v` times the way from the origin are the lengths U and V. */
export function packCells(frame: Frame, origin: Vec3, u: Vec3, v: Vec3, checkerSize: number) {
  const cell = checkerSize * frame.scale;
  const start = toFrame(frame, origin);
  return {
    cellU: u.map((x) => x / cell),
    startU: withinPair(-dot(u, start) / cell),
    cellV: v.map((x) => x / cell),
    startV: withinPair(-dot(v, start) / cell),
  };
}

/** Members of a record for a unit normal, in three parts where that is needed. */
export const normalMembers = [
  { name: 'normal', type: 'vec3' },
  { name: 'normal2', type: 'vec3', when: 'wideRange' },
  { name: 'normal3', type: 'vec3', when: 'wideRange' },
] as const;

/** The values of `normalMembers`. Without the other parts, the first is rounded to f32 as it is. */
export function packNormal(normal: Vec3, wideRange: boolean) {
  const [first, normal2, normal3] = splitParts(normal);
  return { normal: wideRange ? first : normal, normal2, normal3 };
}

/** What f32 leaves of a position. */
export const lowWord = (position: Vec3): Vec3 => position.map((x) => x - Math.fround(x)) as unknown as Vec3;

/** The vectors that measure along u and along v in the plane of both: dualU·u = 1, dualU·v = 0. */
export function duals(u: Vec3, v: Vec3): readonly [Vec3, Vec3] {
  const normal = cross(u, v);
  const square = dot(normal, normal);
  const over = (a: Vec3): Vec3 => a.map((x) => x / square) as unknown as Vec3;
  return [over(cross(v, normal)), over(cross(normal, u))];
}
