/** Twin of shaders/light/environment-image.glsl: the radiance of an image of the surroundings. */
import type { ImageTable } from '../../environment-image.ts';
import { mix, type Vec3 } from '../../vector.ts';

/** Where a direction is in an image that is turned about +y by `turn` of a full turn: texels from the left and the top. */
export function placeInImage({ width, height }: ImageTable, turn: number, [x, y, z]: Vec3): readonly [number, number] {
  const u = Math.atan2(z, x) / (2 * Math.PI) + 0.5 + turn;
  const v = Math.atan2(Math.hypot(x, z), y) / Math.PI;
  return [(u - Math.floor(u)) * width, v * height];
}

/** The colour at a place: linear between the centres of texels, which are at halves. */
export function environmentAt({ width, height, texels }: ImageTable, x: number, y: number): Vec3 {
  const [left, top] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const texel = (i: number, j: number): Vec3 => {
    const at = 4 * (Math.min(Math.max(j, 0), height - 1) * width + ((i + width) % width));
    return [texels[at] as number, texels[at + 1] as number, texels[at + 2] as number];
  };
  const row = (j: number): Vec3 => mix(texel(left, j), texel(left + 1, j), x - 0.5 - left);
  return mix(row(top), row(top + 1), y - 0.5 - top);
}

export const environmentImage = (image: ImageTable, turn: number, direction: Vec3): Vec3 =>
  environmentAt(image, ...placeInImage(image, turn, direction));
