/** Which pixels f32 cannot be asked to get right: those that f64 itself changes when a camera ray moves by one ulp. */
import type { Scene } from '../schema.ts';
import type { Vec3 } from '../vector.ts';
import { type ReferenceImage, type ReferenceSettings, renderReference } from './render.ts';

const nudges: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * One byte per pixel, top row first: 1 where the reference changes by more than `limit`, relative to its largest
 * channel, when a component of the camera ray's direction moves by one ulp of f32.
 *
 * @param still what `renderReference` gave for the same settings, if it is there already: a quarter of the work.
 */
export function illConditioned(
  scene: Scene,
  settings: ReferenceSettings,
  limit: number,
  still: ReferenceImage = renderReference(scene, settings),
): Uint8Array {
  const mask = new Uint8Array(settings.width * settings.height);
  for (const nudge of nudges) {
    const difference = relativeDifference(renderReference(scene, { ...settings, nudge }).data, still);
    difference.forEach((change, pixel) => {
      if (change > limit) mask[pixel] = 1;
    });
  }
  return mask;
}

/**
 * By pixel: the largest difference of a colour channel over the largest colour channel of the reference (0 where both
 * are 0), or the difference in alpha where that is larger.
 */
export function relativeDifference(picture: ArrayLike<number>, reference: ReferenceImage): Float64Array {
  return Float64Array.from({ length: reference.width * reference.height }, (_, pixel) => {
    const at = 4 * pixel;
    const difference = (i: number) => Math.abs((picture[at + i] as number) - (reference.data[at + i] as number));
    const largest = Math.max(...reference.data.subarray(at, at + 3));
    const color = Math.max(difference(0), difference(1), difference(2));
    return Math.max(color === 0 ? 0 : color / largest, difference(3));
  });
}
