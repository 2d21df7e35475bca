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
/** No picture gets this many times as large in a round: where errors fall faster than one over the square root, less is enough. */
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

/** Begins with few samples and takes as many more as `more` says, with other seeds: a round adds to the ones before. */
export async function estimate(render: RenderBatch, options: EstimateOptions): Promise<Estimate> {
  const most = Math.max(1, Math.floor(options.mostSamples / BATCHES));
  const batches = Array.from({ length: BATCHES }, () => new Batch());
  let more = Math.min(PILOT, most);
  for (let round = 0, samples = 0; ; round++) {
    await addRound(render, batches, round, more, options);
    samples += more;
    const result = meanOf(batches, samples);
    options.onRound?.(result);
    const wanted = Math.ceil(samples * Math.min(options.more(result), GROWTH));
    more = Math.min(wanted, most) - samples;
    if (!(more > 0)) return result;
  }
}

async function addRound(
  render: RenderBatch,
  batches: readonly Batch[],
  round: number,
  samples: number,
  { onBatch }: EstimateOptions,
): Promise<void> {
  let done = 0;
  // Batches are asked for at once: whoever renders may have several hands.
  const renders = batches.map(async (batch, i) => {
    batch.add(await render(round * BATCHES + i + 1, samples), samples);
    onBatch?.(++done, BATCHES, samples);
  });
  await Promise.all(renders);
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

/** A picture that gets better: the mean of all its samples so far. */
class Batch {
  rgb = new Float64Array(0);
  #samples = 0;

  add(rgb: Float64Array, samples: number): void {
    this.#samples += samples;
    const part = samples / this.#samples;
    this.rgb = rgb.map((value, i) => (part === 1 ? value : (this.rgb[i] as number) * (1 - part) + value * part));
  }
}

/** @param samples of each batch */
function meanOf(batches: readonly Batch[], samples: number): Estimate {
  const pictures = batches.map(({ rgb }) => rgb);
  const greys = pictures.map(greyOf);
  const means = greys.map(average);
  const mean = average(means);
  return {
    rgb: (pictures[0] as Float64Array).map((_, i) => average(pictures.map((rgb) => rgb[i] as number))),
    error: (greys[0] as Float64Array).map((_, i) => errorOfMean(greys.map((grey) => grey[i] as number))),
    meanError: mean > 0 ? errorOfMean(means) / mean : 0,
    samples: samples * batches.length,
    batches: batches.length,
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
