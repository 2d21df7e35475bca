/** How much the answer to a case moves with its numbers: for cases that the data have nothing to say about. */
import type { Vec3 } from '@ray-scene/core';
import { subtract } from '../../packages/core/src/vector.ts';
import { cameraProblem, positionsOf } from './problem.ts';
import { referenceAnswer } from './reference-side.ts';
import type { VectorCase } from './vector-cases.ts';

export interface Conditioning {
  /** As `condR` of the data: the largest relative change of t when one number moves by an f32 ulp. */
  readonly condR: number;
  /** A number that moves by an f32 ulp changes hit to miss or back, or t altogether. */
  readonly ambiguous: boolean;
  /** As `jump` of the data: it changes t altogether. */
  readonly jump: boolean;
}

/** By the f64 reference. Ulps of places are those of places relative to the first place of the primitive. */
export function conditioning(one: VectorCase): Conditioning {
  const { t } = referenceAnswer(cameraProblem(one));
  const changes = neighbours(one).map((neighbour) => {
    const moved = referenceAnswer(cameraProblem(neighbour)).t;
    return moved === t ? 0 : Math.abs(moved - t) / Math.abs(t);
  });
  const condR = Math.max(...changes.filter((change) => Number.isFinite(change) && change < 1), 0);
  return {
    condR,
    ambiguous: changes.some((change) => !(change < 1)),
    jump: changes.some((change) => Number.isFinite(change) && change >= 1),
  };
}

/** The cases that differ from this one in one number, by an ulp. */
function neighbours(one: VectorCase): readonly VectorCase[] {
  const { prim, p, o, d } = one;
  const [first, ...others] = positionsOf(prim);
  const base = p[first as string] as Vec3;
  const inShape = Object.entries(p)
    .filter(([field]) => field !== first)
    .flatMap(([field, value]) => {
      const values =
        typeof value === 'number'
          ? [Math.fround(value + ulp(value)), Math.fround(value - ulp(value))]
          : moved(value, others.includes(field) ? subtract(value, base) : value);
      return values.map((changed) => ({ ...one, p: { ...p, [field]: changed } }));
    });
  return [
    ...inShape,
    ...moved(o, subtract(o, base)).map((changed) => ({ ...one, o: changed })),
    ...moved(d, d).map((changed) => ({ ...one, d: changed })),
  ];
}

/** A vector with one component moved by an ulp of the same component of another. */
const moved = (v: Vec3, sized: Vec3): readonly Vec3[] =>
  [0, 1, 2].flatMap((axis) =>
    [1, -1].map((sign) => v.map((x, i) => (i === axis ? x + sign * ulp(sized[i] as number) : x)) as unknown as Vec3),
  );

/** Of an f32 number; a zero does not move. */
const ulp = (x: number): number => (x === 0 ? 0 : 2 ** (Math.floor(Math.log2(Math.abs(x))) - 23));
