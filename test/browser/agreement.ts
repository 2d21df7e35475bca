/** How far the GPU's picture of a scene is from the f64 reference, both shot with the same rays. */
import { expect } from '@open-wc/testing';
import type { RenderSettings, Scene } from '@ray-scene/core';
import { illConditioned, relativeDifference, renderReference } from '@ray-scene/core/reference';
import { drawn } from './drawn.ts';

const { RAY_SCENE_FULL: full = false } = globalThis as { RAY_SCENE_FULL?: boolean };

/** Of square pictures whose every pixel the reference draws too, in each engine: it takes most of a run's time. */
export const SIDE = full ? 128 : 96;

/** Relative to the brightest channel of the pixel. */
const LIMIT = 1e-3;

export interface Agreement {
  readonly median: number;
  /** Shares of the pixels: off by more than the limit, and left out because f64 itself moves them as much. */
  readonly off: number;
  readonly excluded: number;
}

export type PictureSettings = Partial<RenderSettings> & { readonly width: number; readonly height: number };

/** A picture of the GPU's: the differences of the pixels that f64 is sure of, and how many are above the limit. */
export function pixelAgreement(picture: Float32Array, scene: Scene, given: PictureSettings) {
  const settings = { integrator: 'direct', ...given } as const;
  const reference = renderReference(scene, settings);
  const difference = relativeDifference(picture, reference);
  const excluded = illConditioned(scene, settings, LIMIT, reference);
  const judged = difference.filter((_, pixel) => !excluded[pixel]);
  return { judged, off: judged.filter((value) => !(value <= LIMIT)).length, all: difference.length };
}

/** By the integrator `direct`, unless the settings name another. */
export function agreement(scene: Scene, settings: PictureSettings): Agreement {
  const { judged, off, all } = pixelAgreement(drawn(scene, settings), scene, settings);
  return {
    median: judged.sort()[judged.length >> 1] ?? 0,
    off: off / judged.length,
    excluded: 1 - judged.length / all,
  };
}

/** Prints what they differ by, and expects it to be rounding: half of the pixels below 1e-5, and less than 0.1 % off. */
export function expectAgreement(what: string, scene: Scene, settings: PictureSettings): void {
  const { median, off, excluded } = agreement(scene, settings);
  const percent = (share: number): string => `${(100 * share).toFixed(3)} %`;
  console.log(`${what}: median ${median.toExponential(1)}, off ${percent(off)}, excluded ${percent(excluded)}`);
  expect(median, 'median').to.be.below(1e-5);
  expect(off, `share of pixels off by more than ${LIMIT}`).to.be.below(1e-3);
  expect(excluded, 'share of ill-conditioned pixels').to.be.below(0.03);
}
