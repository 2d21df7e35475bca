/** When a picture is good enough: whichever of the rules comes first. */
import type { RenderSettings } from '@ray-scene/core';

export type StopReason = 'samples' | 'error' | 'time';

/**
 * With fewer samples, noise is not asked whether it is low enough: a lamp that only one path in ten finds has not been
 * found by any of a few, and all of them agree on darkness. With so many, all examples that have a variance know their
 * noise, or think that they have more; and of twice as many, some would be better than a page has asked for.
 */
export const FEWEST_SAMPLES = 8;

/** How far a picture is. */
export interface Standing {
  /** Samples that every pixel has. */
  readonly samples: number;
  readonly seconds: number;
  /** As last measured, and the samples that there were then. */
  readonly noise: { readonly samples: number; readonly error: number } | undefined;
}

/** The rule that ends a picture here, if one does. */
export function stopReason(
  { samples, maxError, maxTime }: Pick<RenderSettings, 'samples' | 'maxError' | 'maxTime'>,
  standing: Standing,
): StopReason | undefined {
  const { noise } = standing;
  if (standing.samples === 0) return undefined;
  if (maxError !== undefined && noise && noise.samples >= FEWEST_SAMPLES && noise.error <= maxError) return 'error';
  if (standing.samples >= samples) return 'samples';
  return maxTime !== undefined && standing.seconds >= maxTime ? 'time' : undefined;
}
