/** The exact intersections of `data/vectors`; data/README.md says what every field means. */
import type { Vec3 } from '@ray-scene/core';

export const vectorKinds = ['sphere', 'plane', 'disc', 'quad', 'box', 'cylinder', 'cone', 'torus', 'triangle'] as const;

export type VectorKind = (typeof vectorKinds)[number];

/** The numbers of a primitive, by the names that the data have for them. */
export type Shape = { readonly [field: string]: Vec3 | number };

export interface VectorCase {
  readonly id: string;
  readonly prim: VectorKind;
  readonly regime: string;
  readonly p: Shape;
  readonly o: Vec3;
  readonly d: Vec3;
  readonly tmin: number;
  readonly hit: boolean;
  readonly t64?: number;
  readonly n?: Vec3 | null;
  readonly ambiguous: boolean;
  readonly condR?: number;
  readonly cond64?: number;
  readonly nCond?: number;
  readonly flip: number;
  readonly flip64: number;
  readonly jump?: boolean;
  readonly featFlip?: boolean;
  /** Null is a miss. */
  readonly alt?: readonly (number | null)[];
}

export interface WatertightCase {
  readonly id: string;
  readonly tris: readonly (readonly [Vec3, Vec3, Vec3])[];
  readonly o: Vec3;
  readonly d: Vec3;
  readonly mustHit: boolean;
}

/** One JSON value per line. */
export const parseLines = <T>(text: string): readonly T[] =>
  text
    .split('\n')
    .filter((line) => line.trim() !== '')
    .map((line) => JSON.parse(line) as T);
