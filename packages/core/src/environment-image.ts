/**
 * An image of the surroundings, and the table by which directions are drawn from it: the brighter, the likelier.
 * Orientation as in three.js: direction (x, y, z) is at u = atan2(z, x) / 2π + ½, from the left, and v = acos(y) / π, from
 * the top. Texel centres are at (i + ½) / width and (j + ½) / height; between them colours are linear, across the left and
 * right edge too.
 */
import { aliasTable } from './emitter-table.ts';
import { type RowByRow, toEnd } from './row-by-row.ts';

export interface EnvironmentImage {
  readonly width: number;
  readonly height: number;
  /** Linear RGB, the top row first. */
  readonly data: Float32Array;
}

/** What shader and reference read of an image, both the same numbers. */
export interface ImageTable {
  readonly width: number;
  readonly height: number;
  /** For each texel its colour, and how much likelier than the average it is that its square of the image is chosen. */
  readonly texels: Float32Array;
  /** Rows of width + 1 pairs: threshold and alias of each texel within its row; in the last place those of the row. */
  readonly choices: Float32Array;
  /** The integral of the radiance over all directions, in the mean of the channels. */
  readonly irradiance: number;
}

const tables = new WeakMap<EnvironmentImage, ImageTable>();

/** The table of an image, which is made once. */
export const imageTable = (image: EnvironmentImage): ImageTable => toEnd(imageTableByRows(image));

/** The same row by row. Afterwards `imageTable` has it at once. */
export function* imageTableByRows(image: EnvironmentImage): RowByRow<ImageTable> {
  const known = tables.get(image) ?? (yield* makeTable(image));
  tables.set(image, known);
  return known;
}

function* makeTable(image: EnvironmentImage): RowByRow<ImageTable> {
  const { width, height } = image;
  const weights = yield* texelWeights(image);
  const rowSums = Float64Array.from({ length: height }, (_, j) =>
    weights.subarray(j * width, (j + 1) * width).reduce((sum, weight) => sum + weight, 0),
  );
  const rows = aliasTable(rowSums);
  const texels = new Float32Array(4 * width * height);
  const choices = new Float32Array(2 * (width + 1) * height);
  for (let j = 0; j < height; j++) {
    const columns = aliasTable(weights.subarray(j * width, (j + 1) * width));
    const start = 2 * (width + 1) * j;
    for (let i = 0; i < width; i++) {
      const at = j * width + i;
      for (let channel = 0; channel < 3; channel++) texels[4 * at + channel] = lightAt(image, 3 * at + channel);
      texels[4 * at + 3] = (columns.probabilities[i] as number) * (rows.probabilities[j] as number) * width * height;
      choices[start + 2 * i] = columns.thresholds[i] as number;
      choices[start + 2 * i + 1] = columns.aliases[i] as number;
    }
    choices[start + 2 * width] = rows.thresholds[j] as number;
    choices[start + 2 * width + 1] = rows.aliases[j] as number;
    yield;
  }
  const total = rowSums.reduce((sum, weight) => sum + weight, 0);
  return { width, height, texels, choices, irradiance: (2 * Math.PI * total) / width };
}

/** Light that is no number is none. */
const lightAt = ({ data }: EnvironmentImage, i: number): number => Math.min(Math.max(data[i] || 0, 0), LARGEST);

/** As much as a shader takes. */
const LARGEST = 1e30;

/**
 * The mean of the channels over the square of each texel, times the solid angle of its row over 2π. It is the exact mean
 * of what is linear between centres (⅛, ¾, ⅛ of the texels beside each other), so no square with light has no weight.
 */
function* texelWeights(image: EnvironmentImage): RowByRow<Float64Array> {
  const { width, height } = image;
  const across = new Float64Array(width * height);
  const means = new Float64Array(width);
  for (let j = 0; j < height; j++) {
    for (let i = 0; i < width; i++) {
      const at = 3 * (j * width + i);
      means[i] = (lightAt(image, at) + lightAt(image, at + 1) + lightAt(image, at + 2)) / 3;
    }
    for (let i = 0; i < width; i++) across[j * width + i] = blurred(means, (i + width - 1) % width, i, (i + 1) % width);
    yield;
  }
  const weights = new Float64Array(width * height);
  for (let j = 0; j < height; j++) {
    const [above, below] = [Math.max(j - 1, 0) * width, Math.min(j + 1, height - 1) * width];
    const share = [Math.sin((Math.PI * (j + 0.5)) / height), Math.sin(Math.PI / (2 * height))] as const;
    for (let i = 0; i < width; i++) {
      const at = j * width + i;
      weights[at] = 2 * blurred(across, above + i, at, below + i) * share[0] * share[1];
    }
    yield;
  }
  return weights;
}

const blurred = (values: Float64Array, before: number, at: number, after: number): number =>
  ((values[before] as number) + 6 * (values[at] as number) + (values[after] as number)) / 8;
