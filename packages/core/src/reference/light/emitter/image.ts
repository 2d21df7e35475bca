/** Twin of shaders/light/emitter/image.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { scale, type Vec3 } from '../../../vector.ts';
import { circle } from '../../circle.ts';
import { environmentAt, environmentImage, placeInImage } from '../environment-image.ts';
import type { EmitterSample } from './sample.ts';

type Choices = {
  readonly thresholds: (i: number) => number;
  readonly aliases: (i: number) => number;
  readonly count: number;
};

/** A row by way of u[1], a texel of it by way of u[0]; what is left of both is the place in the texel's square. */
export function imageSample(
  { image, intensity, turn }: EmitterOf<'image'>,
  _p: Vec3,
  u: readonly [number, number],
): EmitterSample | undefined {
  const { width, height, choices } = image;
  const pair = (i: number, j: number): number => 2 * (j * (width + 1) + i);
  const row = chooseTexel(
    {
      thresholds: (j) => choices[pair(width, j)] as number,
      aliases: (j) => choices[pair(width, j) + 1] as number,
      count: height,
    },
    u[1],
  );
  const column = chooseTexel(
    {
      thresholds: (i) => choices[pair(i, row.index)] as number,
      aliases: (i) => choices[pair(i, row.index) + 1] as number,
      count: width,
    },
    u[0],
  );
  const [x, y] = [column.index + column.rest, row.index + row.rest];
  const [cosine, sine] = circle(y / (2 * height));
  if (!(sine > 0)) return undefined;
  const around = x / width + 0.5 - turn;
  const [along, across] = circle(around - Math.floor(around));
  return {
    direction: [sine * along, cosine, sine * across],
    distance: Number.POSITIVE_INFINITY,
    radiance: scale(environmentAt(image, x, y), intensity),
    pdf: (image.texels[4 * (row.index * width + column.index) + 3] as number) / (2 * Math.PI * Math.PI * sine),
    delta: false,
  };
}

export function imagePdf({ image, turn }: EmitterOf<'image'>, direction: Vec3): number {
  const { width, height, texels } = image;
  const [x, y] = placeInImage(image, turn, direction);
  const [i, j] = [Math.min(Math.floor(x), width - 1), Math.min(Math.floor(y), height - 1)];
  const sine = Math.hypot(direction[0], direction[2]);
  return sine > 0 ? (texels[4 * (j * width + i) + 3] as number) / (2 * Math.PI * Math.PI * sine) : 0;
}

export const imageRadiance = ({ image, intensity, turn }: EmitterOf<'image'>, direction: Vec3): Vec3 =>
  scale(environmentImage(image, turn, direction), intensity);

/** One of many by an alias table, and what of the random number is left for another use, from 0 to 1. */
function chooseTexel(
  { thresholds, aliases, count }: Choices,
  u: number,
): { readonly index: number; readonly rest: number } {
  const place = Math.fround(Math.fround(u) * count);
  const index = Math.min(Math.floor(place), count - 1);
  const rest = place - index;
  const threshold = thresholds(index);
  return rest < threshold
    ? { index, rest: rest / threshold }
    : { index: aliases(index), rest: threshold < 1 ? (rest - threshold) / (1 - threshold) : rest };
}
