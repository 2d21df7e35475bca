/** One picture of the f64 reference. */
import { type EnvironmentImages, parseScene } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';

export interface ReferenceJob {
  /** What `parseScene` takes. */
  readonly scene: object;
  readonly images?: EnvironmentImages;
  readonly bounces: number;
  readonly width: number;
  readonly height: number;
  readonly seed: number;
  readonly samples: number;
}

/** Linear RGB, the top row first. */
export function renderJob({ scene, ...settings }: ReferenceJob): Float64Array {
  const { data } = renderReference(parseScene(scene), { ...settings, integrator: 'path' });
  return withoutAlpha(data);
}

export const withoutAlpha = (rgba: ArrayLike<number>): Float64Array =>
  Float64Array.from({ length: (rgba.length / 4) * 3 }, (_, i) => rgba[4 * Math.floor(i / 3) + (i % 3)] as number);
