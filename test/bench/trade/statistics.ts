/** What pictures drawn with independent random numbers tell: noise and bias, apart. */

/** Linear radiance, as `relMSE` looks at it: three numbers for each pixel. */
export type Radiance = Float32Array;

/**
 * Share of the pixels that are left out for each way of drawing, those whose variance is largest. Highlights much smaller than a pixel are met by
 * one sample in thousands, and would be all that numbers of a whole picture tell.
 */
const RARE = 0.005;

/** As in the definition of `error`: what is darker than its root is not looked at relatively. */
const EPSILON = 0.01;

/** Sums over pictures that differ by their random numbers alone. */
export class Spread {
  count = 0;
  /** Numbers of a picture. */
  readonly length: number;
  readonly #sum: Float64Array;
  readonly #squares: Float64Array;

  constructor(length: number) {
    this.length = length;
    this.#sum = new Float64Array(length);
    this.#squares = new Float64Array(length);
  }

  add(picture: ArrayLike<number>): void {
    this.count++;
    for (let i = 0; i < this.#sum.length; i++) {
      const value = picture[i] as number;
      this.#sum[i] = (this.#sum[i] as number) + value;
      this.#squares[i] = (this.#squares[i] as number) + value ** 2;
    }
  }

  mean(i: number): number {
    return (this.#sum[i] as number) / this.count;
  }

  /** Of one picture, without bias; needs two. */
  variance(i: number): number {
    return Math.max((this.#squares[i] as number) - this.count * this.mean(i) ** 2, 0) / (this.count - 1);
  }
}

/** What the square of an error is divided by. */
export const relativeTo = (right: number): number => right ** 2 + EPSILON;

/** What the errors of all settings of a scene are measured with. */
export interface Yardstick {
  /** Of each number, what the square of its error is divided by. */
  readonly squares: Float64Array;
  /** Of each number, whether its pixel is one of the rare ones. */
  readonly isRare: readonly boolean[];
}

/**
 * From converged pictures that serve for nothing else. Were the rare pixels chosen by the pictures that are judged, or by what
 * they are held to, those would stay in which rare events happened not to occur: too dark, all of them.
 * @param others drawn in other ways, in which other pixels may be rare.
 */
export function yardstickOf(pictures: Spread, ...others: readonly Spread[]): Yardstick {
  const squares = Float64Array.from({ length: pictures.length }, (_, i) => relativeTo(pictures.mean(i)));
  const rare = new Set([pictures, ...others].flatMap((spread) => rarePixels(spread, squares)));
  return { squares, isRare: Array.from(squares, (_, i) => rare.has(Math.floor(i / 3))) };
}

function rarePixels(spread: Spread, squares: Float64Array): readonly number[] {
  const variances = perPixel(spread.length, (i) => spread.variance(i) / (squares[i] as number));
  const order = [...variances.keys()].sort((a, b) => (variances[b] as number) - (variances[a] as number));
  return order.slice(0, Math.round(RARE * order.length));
}

/** The mean of the three numbers of each pixel. */
const perPixel = (length: number, at: (i: number) => number): readonly number[] =>
  Array.from({ length: length / 3 }, (_, pixel) => (at(3 * pixel) + at(3 * pixel + 1) + at(3 * pixel + 2)) / 3);

export interface Noise {
  /** Root of the mean of variance / (mean² + ε) of one picture, over all of its pixels. */
  readonly noiseOfAll: number;
  /** The same without the rare ones. */
  readonly noise: number;
  /** What share of the variance is that of the rare ones. */
  readonly rareShare: number;
}

export function noiseOf(spread: Spread, { squares, isRare }: Yardstick): Noise {
  const relative = Array.from(squares, (square, i) => spread.variance(i) / square);
  const most = relative.filter((_, i) => !isRare[i]);
  const all = sum(relative);
  return {
    noiseOfAll: Math.sqrt(all / relative.length),
    noise: Math.sqrt(average(most)),
    rareShare: all === 0 ? 0 : 1 - sum(most) / all,
  };
}

export interface Bias {
  /**
   * Mean of (what pictures are on average - what is right)² / (right² + ε), less what noise adds to it. Where there is no bias
   * it is 0 on average, and so below 0 half of the time.
   */
  readonly squaredBias: number;
  /** Its root, or 0. */
  readonly bias: number;
  /** What it may be if chance was unkind: two standard errors more. */
  readonly biasAtMost: number;
}

/**
 * Without the rare pixels. The square of a mean less its variance is the mean of the products of any two different pictures:
 * each factor has noise of its own, so that on average the products have none.
 * @param right pictures of what is right with random numbers of their own. Without them, `pictures` are differences: each of
 * a picture and of what is right with the same random numbers.
 */
export function biasOf(pictures: Spread, { squares, isRare }: Yardstick, right?: Spread): Bias {
  const noiseAt = (i: number): number =>
    (pictures.variance(i) / pictures.count + (right ? right.variance(i) / right.count : 0)) / (squares[i] as number);
  const most = (values: readonly number[]): readonly number[] => values.filter((_, pixel) => !isRare[3 * pixel]);
  const noise = most(perPixel(squares.length, noiseAt));
  const squared = most(
    perPixel(squares.length, (i) => {
      const error = pictures.mean(i) - (right?.mean(i) ?? 0);
      return error ** 2 / (squares[i] as number) - noiseAt(i);
    }),
  );
  const squaredBias = average(squared);
  // Rare events that no two pictures share leave all products 0. That they might have shared them is seen from the noise: of
  // two pictures, a product deviates by their variance.
  const chance = squared.map((value, i) => Math.max(Math.abs(value - squaredBias), 2 * (noise[i] as number)));
  const deviation = Math.sqrt(average(chance.map((value) => value ** 2)) / chance.length);
  const known = Math.max(squaredBias, 0);
  return { squaredBias, bias: Math.sqrt(known), biasAtMost: Math.sqrt(known + 2 * deviation) };
}

const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);

export const average = (values: readonly number[]): number => sum(values) / values.length;

/** sRGB's transfer function (IEC 61966-2-1) on what is shown without a tone curve. */
export function shown(linear: number): number {
  const x = Math.min(1, Math.max(0, linear));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}

/** Of two pictures as they are shown, in decibels. */
export const psnr = (one: ArrayLike<number>, other: ArrayLike<number>): number =>
  -10 * Math.log10(average(Array.from(one, (value, i) => (value - (other[i] as number)) ** 2)));

/** The middle one and the mean distance of the middle half from it. */
export function typical(values: readonly number[]): { readonly median: number; readonly spread: number } {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share: number): number => sorted[Math.round(share * (sorted.length - 1))] as number;
  return { median: at(0.5), spread: (at(0.75) - at(0.25)) / 2 };
}
