/**
 * An image of the surroundings in the other renderer's places of texels as one in ours. Theirs is at u = atan2(x, -z) / 2π,
 * which is ours less a quarter of a turn, and has its first and last row at the poles, where ours has their edges.
 */
import type { EnvironmentImage, EnvironmentImages } from '@ray-scene/core';
import type { NeutralScene } from './neutral-scene.ts';

/** In degrees. */
export const ENVIRONMENT_ROTATION = -90;

/**
 * Rows of ours for what lies between two of theirs: where theirs has its kinks, ours is off by 1 / 240 of the kink, which a
 * sky without noise shows if it is more.
 */
const FINER = 60;

/** @param data linear RGB, the top row first. */
export function translateEnvironment({ width, height, data }: EnvironmentImage): EnvironmentImage {
  const rows = FINER * (height - 1);
  const rgb = new Float32Array(3 * width * rows);
  for (let j = 0; j < rows; j++) {
    const place = (j + 0.5) / FINER;
    const above = Math.floor(place);
    for (let i = 0; i < 3 * width; i++) {
      const [a, b] = [data[3 * width * above + i] as number, data[3 * width * (above + 1) + i] as number];
      rgb[3 * width * j + i] = a + (b - a) * (place - above);
    }
  }
  return { width, height: rows, data: rgb };
}

/** The images that a scene asks for; `read` reads a file by its name. */
export async function environmentImages(
  { environment }: NeutralScene,
  read: (name: string) => Promise<ArrayBuffer>,
): Promise<EnvironmentImages> {
  const { file, width, height } = environment ?? {};
  if (!file || !width || !height) return new Map();
  const data = new Float32Array(await read(file));
  return new Map([[file, translateEnvironment({ width, height, data })]]);
}
