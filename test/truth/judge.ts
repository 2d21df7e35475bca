/** Right or wrong, and by how much: the rules of data/README.md, section 1. */
import type { Vec3 } from '@ray-scene/core';
import { cross, dot, length, negate } from '../../packages/core/src/vector.ts';
import { type Conditioning, conditioning } from './conditioning.ts';
import { type Answer, secondaryCase, secondaryProblem } from './problem.ts';
import { referenceAnswer } from './reference-side.ts';
import type { VectorCase } from './vector-cases.ts';

export type Side = 'reference' | 'gpu-camera' | 'gpu-secondary';

/** What is right, and how exactly it can be asked for. */
export interface Expected {
  /** Infinity for a miss. */
  readonly t: number;
  /** Other values that are right too. */
  readonly others: readonly number[];
  /** The relative error that counts as 1. */
  readonly unit: number;
  /** Whether it is hit is not judged. */
  readonly excused: boolean;
  /** Where it is hit is not judged: rounding decides between several surfaces. */
  readonly distanceExcused: boolean;
  /** The plain relative error is not judged: t is ill-conditioned even in f64. */
  readonly rawExcused: boolean;
  /** Any of these; none: it is not judged. */
  readonly normals: readonly Vec3[];
  readonly normalUnit: number;
}

/** What came of one case. */
export interface Judged {
  readonly one: VectorCase;
  readonly verdict: Verdict;
}

export interface Verdict {
  readonly wrong: boolean;
  /** These three: undefined unless both hit. */
  readonly error?: number | undefined;
  readonly raw?: number | undefined;
  readonly normalError?: number | undefined;
}

/** Half an ulp of 1. */
const F32 = 2 ** -24;
const F64 = 2 ** -53;
/** What an f64 ulp is of an f32 ulp. */
const F64_OF_F32 = 2 ** -29;
/** Above this, `cond64` says that t says little. */
const ILL_CONDITIONED = 1e-9;

/** Of a case that the data say everything of. */
const WELL: Conditioning = { condR: 0, ambiguous: false, jump: false };

const flips = (count: number): boolean => count === 1 || count === 4;

/** What the data say of a case. */
export function expected(one: VectorCase, side: 'reference' | 'gpu-camera'): Expected {
  const f64 = side === 'reference';
  const { t64 = Number.POSITIVE_INFINITY, condR = 0, nCond = 0, flip, flip64, alt = [], d } = one;
  const jumps = one.jump && (!f64 || flips(flip64));
  return {
    t: t64,
    others: jumps ? alt.map((t) => t ?? Number.POSITIVE_INFINITY) : [],
    unit: f64 ? Math.max(condR * F64_OF_F32, F64) : Math.max(condR, F32),
    excused: one.ambiguous || flips(f64 ? flip64 : flip),
    distanceExcused: false,
    rawExcused: one.regime === 'huge' && (one.cond64 ?? 0) > ILL_CONDITIONED,
    normals: one.featFlip || flip === 1 || !one.n ? [] : f64 ? [one.n] : turned(one.n, d, nCond),
    normalUnit: f64 ? Math.max(nCond * F64_OF_F32, F64) : Math.max(nCond, F32),
  };
}

/**
 * A case as its secondary path is asked, and what the f64 reference says to that. It is another case: rounding has moved it
 * by about an ulp. Where that is said to be enough for a ray to meet something else (`jump`), what it meets now, and where
 * all that it could meet has gone, the data do not say. The limits of this path except those cases.
 */
export function secondary(original: VectorCase): { readonly moved: VectorCase; readonly expected: Expected } {
  const moved = secondaryCase(original);
  const truth = expected(original, 'gpu-camera');
  const answer = referenceAnswer(secondaryProblem(moved));
  const same = original.hit ? Math.abs(answer.t - truth.t) < truth.t : !Number.isFinite(answer.t);
  // Else the data may not say how the case that rounding has made of it is conditioned.
  const own = same && !flips(original.flip) ? WELL : conditioning(moved);
  return {
    moved,
    expected: {
      ...truth,
      t: answer.t,
      others: [],
      unit: Math.max(truth.unit, own.condR),
      excused: truth.excused || (!same && own.ambiguous),
      distanceExcused: !!original.jump || (!same && own.jump),
      normals: same && truth.normals.length > 0 ? turned(answer.normal, original.d, truth.normalUnit) : [],
    },
  };
}

export function judge({ t, normal }: Answer, right: Expected): Verdict {
  if (Number.isNaN(t) || t === Number.NEGATIVE_INFINITY) return { wrong: true };
  const hit = Number.isFinite(t);
  const hits = [right.t, ...right.others].filter(Number.isFinite);
  const allowsMiss = hits.length <= right.others.length;
  if (!hit) return { wrong: !right.excused && !allowsMiss };
  if (hits.length === 0) return { wrong: !right.excused };
  const wrong = normal.some((x) => !Number.isFinite(x));
  if (right.distanceExcused) return { wrong };
  const raw = Math.min(...hits.map((value) => Math.abs(t - value) / Math.abs(value)));
  return {
    wrong,
    error: raw / right.unit,
    raw: right.rawExcused ? undefined : raw,
    normalError: Math.abs(t - right.t) <= raw * right.t ? normalError(normal, right) : undefined,
  };
}

/** The normal on the side that the ray comes from; both where that is too close to tell. */
function turned(outward: Vec3, direction: Vec3, nCond: number): readonly Vec3[] {
  const cosine = dot(outward, direction);
  if (Math.abs(cosine) < 4 * Math.max(nCond, F32)) return [outward, negate(outward)];
  return [cosine > 0 ? negate(outward) : outward];
}

const normalError = (normal: Vec3, { normals, normalUnit }: Expected): number | undefined =>
  normals.length === 0 ? undefined : Math.min(...normals.map((right) => angle(normal, right))) / normalUnit;

const angle = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));
