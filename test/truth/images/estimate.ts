/** A picture of ours with its own standard errors: the mean of independent batches, as large as the judging needs. */

/** Linear RGB of a picture, the top row first: the mean of so many samples of a seed. */
export type RenderBatch = (seed: number, samples: number) => Promise<Float64Array>;

export interface Estimate {
  readonly rgb: Float64Array;
  /** Standard error of the grey mean (R + G + B) / 3 of each pixel. */
  readonly error: Float64Array;
  /** Standard error of the image's grey mean, relative to it. */
  readonly meanError: number;
  /** Per pixel, in all batches. */
  readonly samples: number;
  readonly batches: number;
}

/** So many independent pictures say how far off their mean is: their spread is then known to 18 %. */
const BATCHES = 16;
/** Samples of each batch in the first round. */
const PILOT = 8;
/** No round grows by more than this: where errors fall faster than one over the square root, less is enough. */
const GROWTH = 16;

export interface EstimateOptions {
  /** How many times as many samples it should have; up to 1: it has enough. */
  readonly more: (estimate: Estimate) => number;
  /** Per pixel, in all batches: where it ends in any case. */
  readonly mostSamples: number;
  readonly onRound?: (estimate: Estimate) => void;
}

/** Begins with few samples and takes as many more as `more` says, each time with other seeds. */
export async function estimate(render: RenderBatch, options: EstimateOptions): Promise<Estimate> {
  const most = Math.max(1, Math.floor(options.mostSamples / BATCHES));
  let samples = Math.min(PILOT, most);
  for (let round = 0; ; round++) {
    const result = await meanOfBatches(render, samples, round);
    options.onRound?.(result);
    const more = options.more(result);
    if (!(more > 1) || samples >= most) return result;
    // A sequence of Sobol points is at its best in powers of two.
    samples = Math.min(most, samples * Math.min(GROWTH, 2 ** Math.ceil(Math.log2(more))));
  }
}

async function meanOfBatches(render: RenderBatch, samples: number, round: number): Promise<Estimate> {
  // Batches are asked for at once: whoever renders may have several hands.
  const seeds = Array.from({ length: BATCHES }, (_, batch) => round * BATCHES + batch + 1);
  const gathered = new Gathered();
  await Promise.all(seeds.map(async (seed) => gathered.add(await render(seed, samples))));
  return gathered.estimate(samples);
}

/** For who draws one picture after the other: `estimate` asks for many at once. */
export function inTurns(render: RenderBatch): RenderBatch {
  let last: Promise<unknown> = Promise.resolve();
  return (seed, samples) => {
    const next = last.then(() => render(seed, samples));
    last = next;
    return next;
  };
}

/** Running means and sums of squared deviations (B. Welford, Technometrics 4(3), 1962). */
class Gathered {
  #count = 0;
  #rgb = new Float64Array(0);
  #grey = new Float64Array(0);
  #squares = new Float64Array(0);
  readonly #means: number[] = [];

  add(rgb: Float64Array): void {
    const grey = greyOf(rgb);
    if (this.#count === 0) {
      this.#rgb = new Float64Array(rgb.length);
      this.#grey = new Float64Array(grey.length);
      this.#squares = new Float64Array(grey.length);
    }
    const count = ++this.#count;
    this.#means.push(average(grey));
    this.#rgb.forEach((mean, i, all) => {
      all[i] = mean + ((rgb[i] as number) - mean) / count;
    });
    this.#grey.forEach((mean, i, all) => {
      const step = (grey[i] as number) - mean;
      const next = mean + step / count;
      all[i] = next;
      this.#squares[i] = (this.#squares[i] as number) + step * ((grey[i] as number) - next);
    });
  }

  estimate(samples: number): Estimate {
    const count = this.#count;
    const mean = average(this.#means);
    const spread = this.#means.reduce((sum, value) => sum + (value - mean) ** 2, 0);
    const errorOf = (squares: number): number => Math.sqrt(squares / (count - 1) / count);
    return {
      rgb: this.#rgb,
      error: this.#squares.map(errorOf),
      meanError: mean > 0 ? errorOf(spread) / mean : 0,
      samples: samples * count,
      batches: count,
    };
  }
}

/** (R + G + B) / 3 of each pixel. */
export const greyOf = (rgb: ArrayLike<number>): Float64Array =>
  Float64Array.from(
    { length: rgb.length / 3 },
    (_, i) => ((rgb[3 * i] as number) + (rgb[3 * i + 1] as number) + (rgb[3 * i + 2] as number)) / 3,
  );

export const average = (values: Iterable<number>): number => {
  let sum = 0;
  let count = 0;
  for (const value of values) {
    sum += value;
    count++;
  }
  return count > 0 ? sum / count : 0;
};
