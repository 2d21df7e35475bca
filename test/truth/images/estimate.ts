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

/**
 * So many independent pictures say how far off their mean is: their spread is then known to 13 %. Where our errors are much
 * larger than the truth's, z has Student's distribution with one degree of freedom less, and rmsZ is 1.03 if all is right.
 */
const BATCHES = 32;
/** Samples of each batch in the first round. */
const PILOT = 4;
/** No round grows by more than this: where errors fall faster than one over the square root, less is enough. */
const GROWTH = 16;

export interface EstimateOptions {
  /** How many times as many samples it should have; up to 1: it has enough. */
  readonly more: (estimate: Estimate) => number;
  /** Per pixel, in all batches: where it ends in any case. */
  readonly mostSamples: number;
  readonly onRound?: (estimate: Estimate) => void;
  /** Told at each picture of a round, of which there are so many, with so many samples each. */
  readonly onBatch?: (done: number, batches: number, samples: number) => void;
}

/** Begins with few samples and takes as many more as `more` says, each time with other seeds. */
export async function estimate(render: RenderBatch, options: EstimateOptions): Promise<Estimate> {
  const most = Math.max(1, Math.floor(options.mostSamples / BATCHES));
  let samples = Math.min(PILOT, most);
  for (let round = 0; ; round++) {
    // Nothing of the round before is kept: in smooth pictures its few samples would do more harm than good.
    const result = await meanOfBatches(render, samples, round, options);
    options.onRound?.(result);
    const more = options.more(result);
    if (!(more > 1) || samples >= most) return result;
    samples = Math.min(most, balanced(samples * Math.min(GROWTH, more)));
  }
}

/** So many or a few more: sequences of Sobol points are at their best in powers of two, and good in halves between these. */
function balanced(samples: number): number {
  const power = 2 ** Math.ceil(Math.log2(samples));
  return samples <= 0.75 * power ? 0.75 * power : power;
}

async function meanOfBatches(
  render: RenderBatch,
  samples: number,
  round: number,
  { onBatch }: EstimateOptions,
): Promise<Estimate> {
  let done = 0;
  // Batches are asked for at once: whoever renders may have several hands.
  const pictures = Array.from({ length: BATCHES }, async (_, i) => {
    const rgb = await render(round * BATCHES + i + 1, samples);
    onBatch?.(++done, BATCHES, samples);
    return rgb;
  });
  return meanOf(await Promise.all(pictures), samples);
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

/** @param samples of each picture */
function meanOf(pictures: readonly Float64Array[], samples: number): Estimate {
  const greys = pictures.map(greyOf);
  const means = greys.map(average);
  const mean = average(means);
  return {
    rgb: (pictures[0] as Float64Array).map((_, i) => average(pictures.map((rgb) => rgb[i] as number))),
    error: (greys[0] as Float64Array).map((_, i) => errorOfMean(greys.map((grey) => grey[i] as number))),
    meanError: mean > 0 ? errorOfMean(means) / mean : 0,
    samples: samples * pictures.length,
    batches: pictures.length,
  };
}

/** Standard error of the mean of independent values. */
function errorOfMean(values: readonly number[]): number {
  const mean = average(values);
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return Math.sqrt(squares / (values.length - 1) / values.length);
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
