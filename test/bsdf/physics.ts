/** What the tests of both sides ask of samples of a BSDF. */
import type { Vec3 } from '@ray-scene/core';
import { type Bsdf, type BsdfSample, bsdfValue } from '../../packages/core/src/reference/material/bsdf.ts';
import { materials } from './cases.ts';

/** A unit vector whose z is given. */
export const directionTo = (z: number, turn = 0.1): Vec3 => {
  const r = Math.sqrt((1 - z) * (1 + z));
  return [r * Math.cos(2 * Math.PI * turn), r * Math.sin(2 * Math.PI * turn), z];
};

/** Those materials whose lobes are wide enough for a histogram of directions. */
export const wideMaterials = Object.entries(materials).filter(
  ([, { alpha, eta }]) => alpha >= 0.2 && Math.abs(eta - 1) > 0.1,
);

/** So many bins around the normal, and from pole to pole. */
const TURNS = 16;
const BANDS = 32;

/** Shares of directions, bin by bin; the last one has those without a density: mirrored, or absorbed. */
function expectedShares(bsdf: Bsdf, wo: Vec3): readonly number[] {
  const fine = 8;
  const bins = Array.from({ length: BANDS * TURNS }, (_, bin) => {
    let sum = 0;
    for (let i = 0; i < fine * fine; i++) {
      const z = -1 + (2 * (Math.floor(bin / TURNS) + (Math.floor(i / fine) + 0.5) / fine)) / BANDS;
      sum += bsdfValue(bsdf, wo, directionTo(z, ((bin % TURNS) + ((i % fine) + 0.5) / fine) / TURNS)).pdf;
    }
    return (sum / fine ** 2) * ((4 * Math.PI) / (BANDS * TURNS));
  });
  return [...bins, 1 - bins.reduce((a, b) => a + b)];
}

function binOf({ wi: [x, y, z], pdf }: BsdfSample): number {
  if (pdf === 0) return BANDS * TURNS;
  const turn = (Math.atan2(y, x) / (2 * Math.PI) + 1) % 1;
  return Math.min(Math.floor(((z + 1) / 2) * BANDS), BANDS - 1) * TURNS + Math.floor(turn * TURNS);
}

/**
 * How far the histogram of samples is from what the density says, in standard deviations: chi² over the bins that expect
 * enough, and the number in all others.
 */
export function histogramError(bsdf: Bsdf, wo: Vec3, samples: readonly BsdfSample[]): number {
  const expected = expectedShares(bsdf, wo).map((share) => share * samples.length);
  const found = expected.map(() => 0);
  for (const bin of samples.map(binOf)) found[bin] = (found[bin] as number) + 1;
  const rest = { expected: 0, found: 0 };
  let [chi2, freedom] = [0, 0];
  expected.forEach((count, bin) => {
    const seen = found[bin] as number;
    if (count >= 8) {
      chi2 += (seen - count) ** 2 / count;
      freedom++;
    } else {
      rest.expected += count;
      rest.found += seen;
    }
  });
  // A handful is no normal distribution: eight more or less say nothing.
  const restError = Math.max(Math.abs(rest.found - rest.expected) - 8, 0) / Math.sqrt(Math.max(rest.expected, 1));
  return Math.max((chi2 - freedom) / Math.sqrt(2 * freedom), restError);
}

/** Midpoints of both numbers, with weights. The second comes close to 1, where facets are so steep that light is lost. */
export const midpoints = Array.from({ length: 64 * 128 }, (_, i) => {
  const rest = (Math.floor(i / 64) + 0.5) / 128;
  return { u: [((i % 64) + 0.5) / 64, 1 - rest ** 3] as const, weight: (3 * rest ** 2) / (64 * 128) };
});

/** Albedos of a white metal by `alpha` and `cosTheta`, from data/README.md of the truth, section 2. */
export interface Furnace {
  readonly alpha: readonly number[];
  readonly cosTheta: readonly number[];
  /** With the separable Smith term. */
  readonly E_sep: readonly (readonly number[])[];
}
