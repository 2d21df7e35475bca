/**
 * Which cells get the next samples: those where a sample lowers the error of the picture most. Loaded with what measures
 * noise. Knows no WebGL.
 *
 * The square of the error is the mean over the pixels of s² / n, where s² is the relative variance of one sample and n how
 * many there are. For a given number of samples it is least where n is proportional to s (Neyman's allocation), and then
 * it takes (mean s)² / (mean s²) of the samples that it would take if all cells had equally many.
 *
 * Whoever decides by samples how many there are to be makes their mean biased: a cell that looks calm by luck gets few
 * more. Here all 768 numbers of a cell decide together, so that one pixel says little about its own count, and no cell
 * passes for calmer than CALMEST. What is left of the bias is measured by `npm run bench -- --adaptive`.
 */
import type { Cells, Tile } from './cells.ts';
import type { Noise } from './noise-meter.ts';

/** Least spread of a cell, as a part of the root mean square of all: a lamp that few paths find may not be found yet. */
const CALMEST = 0.25;
/**
 * Where all cells alike need hardly more samples than this part of theirs, they get equally many: many small tiles take
 * longer than a few large ones.
 */
const WORTH = 0.9;
/** Goals are set for so many more samples at a time, as a part of those that there are. */
const WAVE = 0.05;
/** Steps of spreads, for each factor of two: neighbours with equally many samples are drawn together. */
const LEVELS = 2;
/** Halvings of an interval: more than an f32 can tell apart. */
const HALVINGS = 30;

export class AdaptiveOrder {
  /** Root of the mean relative variance of a sample, by cell. */
  readonly #spreads: Float64Array;
  readonly #goals: Uint32Array;
  readonly #pays: boolean;

  /** @param noise of the picture, as last measured. */
  constructor({ cells, counts }: Pick<Noise, 'cells' | 'counts'>) {
    const spreads = Float64Array.from(cells, (error, i) => error * Math.sqrt(counts[i] as number));
    const calmest = CALMEST * Math.sqrt(meanOf(spreads.map((spread) => spread ** 2)));
    this.#spreads = spreads.map((spread) => inSteps(Math.max(spread, calmest)));
    this.#pays = meanOf(this.#spreads) ** 2 < WORTH * meanOf(this.#spreads.map((spread) => spread ** 2));
    this.#goals = new Uint32Array(cells.length);
  }

  /**
   * The next tiles to draw, of at most so many cells together, which have equally many samples; undefined: all have as many
   * as they may have, or are so much alike that they are to have equally many.
   * @param cap samples that a pixel is to have at most.
   */
  next(cells: Cells, most: number, cap: number): readonly Tile[] | undefined {
    if (!this.#pays) return undefined;
    return this.#tiles(cells, most) ?? (this.#setGoals(cells, cap) ? this.#tiles(cells, most) : undefined);
  }

  /** Of the cells that want more, those with fewest samples, in pieces of one row: one sample, one target takes them all. */
  #tiles({ counts, columns }: Cells, most: number): readonly Tile[] | undefined {
    const wants = (i: number) => (counts[i] as number) < (this.#goals[i] as number);
    const fewest = counts.reduce((least, count, i) => (wants(i) ? Math.min(least, count) : least), Infinity);
    const isNext = (i: number) => counts[i] === fewest && wants(i);
    const tiles: Tile[] = [];
    let left = most;
    for (let first = 0; first < counts.length && left > 0; first++) {
      if (!isNext(first)) continue;
      const longest = Math.min(left, columns - (first % columns));
      let count = 1;
      while (count < longest && isNext(first + count)) count++;
      tiles.push({ first, count });
      first += count - 1;
      left -= count;
    }
    return tiles.length > 0 ? tiles : undefined;
  }

  /** Distributes a wave of samples so that the counts come as near to being proportional to spreads as they can. */
  #setGoals(cells: Cells, cap: number): boolean {
    const pixels = Array.from(cells.counts, (_, i) => cells.pixelsOf({ first: i, count: 1 }));
    const wanted = (factor: number, i: number) =>
      Math.max(cells.counts[i] as number, Math.min(cap, evenly(factor * (this.#spreads[i] as number))));
    const raysWith = (factor: number) => pixels.reduce((sum, ofCell, i) => sum + wanted(factor, i) * ofCell, 0);
    const rays = (1 + WAVE) * cells.rays;
    let [low, high] = [0, cap / calmestOf(this.#spreads)];
    for (let i = 0; i < HALVINGS; i++) {
      const factor = (low + high) / 2;
      if (raysWith(factor) < rays) low = factor;
      else high = factor;
    }
    for (const i of this.#goals.keys()) this.#goals[i] = wanted(high, i);
    return this.#goals.some((goal, i) => goal > (cells.counts[i] as number));
  }
}

const meanOf = (values: Float64Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;

const calmestOf = (spreads: Float64Array): number => spreads.reduce((a, b) => Math.min(a, b));

const inSteps = (spread: number): number => (spread > 0 ? 2 ** (Math.round(LEVELS * Math.log2(spread)) / LEVELS) : 0);

/**
 * At least so many samples, and of those numbers with which a Sobol sequence covers the square evenly: multiples of a power
 * of two, here of an eighth to a quarter of it.
 */
function evenly(samples: number): number {
  const step = 2 ** Math.max(0, Math.floor(Math.log2(samples)) - 2);
  return Math.ceil(samples / step) * step;
}
