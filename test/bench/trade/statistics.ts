/** What pictures drawn with independent random numbers tell: noise and bias, apart. */

/** Linear radiance, as `relMSE` looks at it: three numbers for each pixel. */
export type Radiance = Float32Array;

/** A picture that is known as well as it could be paid for. */
export interface Converged {
  readonly mean: Radiance;
  /** Of each number, the square of its standard error. */
  readonly variance: Float64Array;
}

/**
 * Share of the pixels that are left out, those whose variance is largest. Highlights much smaller than a pixel are met by
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

  /** The mean of all of them and how well it is known. */
  converged(): Converged {
    const indices = this.#sum.map((_, i) => i);
    return {
      mean: Float32Array.from(indices, (i) => this.mean(i)),
      variance: Float64Array.from(indices, (i) => this.variance(i) / this.count),
    };
  }
}

/** What the square of an error is divided by. */
export const relativeTo = (right: number): number => right ** 2 + EPSILON;

/** Of each number, whether its pixel is one of the rare ones. */
function rareNumbers(variances: readonly number[]): readonly boolean[] {
  const ofPixel = (i: number): number => sum(variances.slice(3 * i, 3 * i + 3));
  const pixels = Array.from({ length: variances.length / 3 }, (_, i) => ({ i, variance: ofPixel(i) }));
  const worst = pixels.sort((a, b) => b.variance - a.variance).slice(0, Math.round(RARE * pixels.length));
  const rare = new Set(worst.map(({ i }) => i));
  return variances.map((_, i) => rare.has(Math.floor(i / 3)));
}

export interface Noise {
  /** Root of the mean of variance / (mean² + ε) of one picture, over all of its pixels. */
  readonly noiseOfAll: number;
  /** The same without the rare ones. */
  readonly noise: number;
  /** What share of the variance is that of the rare ones. */
  readonly rareShare: number;
}

export function noiseOf(spread: Spread, { mean }: Converged): Noise {
  const relative = Array.from(mean, (value, i) => spread.variance(i) / relativeTo(value));
  const isRare = rareNumbers(relative);
  const most = relative.filter((_, i) => !isRare[i]);
  const all = sum(relative);
  return {
    noiseOfAll: Math.sqrt(all / relative.length),
    noise: Math.sqrt(average(most)),
    rareShare: all === 0 ? 0 : 1 - sum(most) / all,
  };
}

export interface Bias {
  /** Root of the mean of (what pictures are on average - what is right)² / (right² + ε). */
  readonly bias: number;
  /** What it may be if chance was unkind: two standard errors more. */
  readonly biasAtMost: number;
}

/** Without the rare pixels, and without what is left of noise in the mean and in what is held to be right. */
export function biasOf(spread: Spread, { mean, variance }: Converged): Bias {
  const noise = Array.from(
    mean,
    (value, i) => (spread.variance(i) / spread.count + (variance[i] as number)) / relativeTo(value),
  );
  const isRare = rareNumbers(noise);
  const squares = Array.from(
    mean,
    (value, i) => (spread.mean(i) - value) ** 2 / relativeTo(value) - (noise[i] as number),
  ).filter((_, i) => !isRare[i]);
  const square = average(squares);
  const deviation = Math.sqrt(average(squares.map((value) => (value - square) ** 2)) / squares.length);
  const known = Math.max(square, 0);
  return { bias: Math.sqrt(known), biasAtMost: Math.sqrt(known + 2 * deviation) };
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
