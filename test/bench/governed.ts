/**
 * `npm run bench -- --adaptive`: what it brings that samples go where the error is, and how far the noise at the stop is
 * from what was asked for. Every scene is drawn again and again with `max-error`, evenly and adapted, each time with other
 * random numbers: how pictures that were made alike differ is their true noise, and how the two kinds differ in the mean
 * is what adapting has biased.
 */
import type { RenderSettings } from '@ray-scene/core';
import { FEWEST_SAMPLES } from '../../packages/ray-scene/src/stop-rules.ts';
import type { BenchBrowser, BenchPage } from './browser-pages.ts';
import { childrenCpuMs } from './cpu-time.ts';
import type { Stop } from './governed-page.ts';

declare const governed: typeof import('./governed-page.ts');

/** The module of the pages that this runs in. */
export const GOVERNED_PAGE = { entry: 'test/bench/governed-page.ts', name: 'governed' } as const;

interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * From that of a small picture in a page, 600 cells, down: of few cells nearly all have an edge in them, and it is told to
 * bring less than it does that they are drawn unevenly.
 */
const SIZES: readonly Size[] = [
  { width: 480, height: 320 },
  { width: 192, height: 128 },
  { width: 128, height: 80 },
];
/** A scene gets the largest in which a picture takes no longer, as far as a few samples tell. */
const PICTURE_MS = 60_000;
const FEW_SAMPLES = 20;

/** Turns in which two pictures of each kind are drawn: so many at most, and none begins after so long. */
const TURNS = 8;
const TURNS_MS = 20_000;

export interface Governed extends Size {
  readonly scene: string;
  readonly maxError: number;
  /** Of two even and two adapted pictures each. */
  readonly turns: number;
  /** True noise over what was asked for, at the stop. */
  readonly evenNoise: number;
  readonly adaptedNoise: number;
  /** Samples per pixel, in the mean. */
  readonly evenSamples: number;
  readonly adaptedSamples: number;
  /** GPU time of adapted pictures over that of even ones. */
  readonly timeRatio: number;
  /** The same of all that processors did, where the system tells: it does not depend on what else they had to do. */
  readonly cpuRatio: number;
  /** That, times what the square of the true noise was over that of even ones: as if both had ended with the same. */
  readonly equalRatio: number;
  /** The square of what adapting has biased over what was asked for, without noise in the mean; and its standard error. */
  readonly squaredBias: number;
  readonly squaredBiasError: number;
  /** What ended the pictures; 'error' unless `samples` were too few. */
  readonly reasons: readonly string[];
}

interface SceneText {
  readonly name: string;
  readonly scene: string;
}

export async function measureGoverned(
  browser: BenchBrowser,
  scenes: readonly SceneText[],
  maxErrors: readonly number[],
  samples: number,
): Promise<readonly Governed[]> {
  const results: Governed[] = [];
  for (const maxError of maxErrors) {
    printHead(maxError);
    const rows: Governed[] = [];
    for (const { name, scene } of scenes) {
      const page = await browser.open();
      const measured = await measureScene(page, scene, maxError, { integrator: 'path', samples, maxError });
      rows.push({ scene: name, maxError, ...measured });
      print(rows.at(-1) as Governed);
    }
    printFoot(rows);
    results.push(...rows);
  }
  return results;
}

const SMALLEST = SIZES.at(-1) as Size;

/** By a picture of a few samples at the smallest size. */
function sizeFor({ gpuMs, stats }: Stop, maxError: number): Size {
  const pictures = ((stats.error ?? 0) / maxError) ** 2 * gpuMs;
  const msAt = ({ width, height }: Size): number => (pictures * width * height) / (SMALLEST.width * SMALLEST.height);
  return SIZES.find((size) => msAt(size) <= PICTURE_MS) ?? SMALLEST;
}

async function measureScene(page: BenchPage, scene: string, maxError: number, settings: Partial<RenderSettings>) {
  const stopAt = (size: Size, adapts: boolean, more: Partial<RenderSettings>): Promise<Stop> =>
    page.execute((task) => governed.stop(task), { ...size, scene, settings: { ...settings, ...more }, adapts });
  // The first time for drivers, which compile again for what they meet first, as adding to what is there.
  for (const seed of [1000, 1001]) await stopAt(SMALLEST, true, { seed, samples: FEW_SAMPLES });
  const size = sizeFor(await stopAt(SMALLEST, false, { seed: 1002, samples: FEW_SAMPLES }), maxError);
  const stop = (adapts: boolean, seed: number) => stopAt(size, adapts, { seed });
  await page.execute(() => governed.begin(), undefined);
  const pictures = { even: [] as Drawn[], adapted: [] as Drawn[] };
  const draw = async (adapts: boolean, seed: number): Promise<void> => {
    const before = childrenCpuMs();
    const { reason, stats, gpuMs } = await stop(adapts, seed);
    const after = childrenCpuMs();
    const cpuMs = before === undefined || after === undefined ? gpuMs : after - before;
    await page.execute((picture) => governed.keep(picture), { sum: (adapts ? 2 : 0) + (seed % 2), adapts });
    const samples = stats.rays / (size.width * size.height);
    pictures[adapts ? 'adapted' : 'even'].push({ gpuMs, cpuMs, reason, samples });
  };
  const end = performance.now() + TURNS_MS;
  let turn = 0;
  do {
    // In turn first and last, so that a machine which becomes busier favours neither. One of each kind has the same seed: of
    // the samples that both have, nothing is in their difference, which is as much less noisy as that is many.
    for (const [i, adapts] of [false, true, true, false].entries()) await draw(adapts, 2 * turn + (i >> 1));
    turn++;
  } while (turn < TURNS && performance.now() < end);
  const { noise, squaredBias, squaredBiasError } = await page.execute((each) => governed.judge(each), turn);
  const ratioOf = (value: (picture: Drawn) => number): number =>
    mean(pictures.adapted.map(value)) / mean(pictures.even.map(value));
  const [evenNoise, adaptedNoise] = noise.map((error) => error / maxError) as [number, number];
  const cpuRatio = ratioOf(({ cpuMs }) => cpuMs);
  return {
    ...size,
    turns: turn,
    evenNoise,
    adaptedNoise,
    evenSamples: mean(pictures.even.map(({ samples }) => samples)),
    adaptedSamples: mean(pictures.adapted.map(({ samples }) => samples)),
    timeRatio: ratioOf(({ gpuMs }) => gpuMs),
    cpuRatio,
    equalRatio: cpuRatio * (adaptedNoise / evenNoise) ** 2,
    squaredBias: squaredBias / maxError ** 2,
    squaredBiasError: squaredBiasError / maxError ** 2,
    reasons: [...new Set([...pictures.even, ...pictures.adapted].map(({ reason }) => reason))],
  };
}

interface Drawn {
  readonly gpuMs: number;
  readonly cpuMs: number;
  readonly samples: number;
  readonly reason: string;
}

const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return mean([sorted[(sorted.length - 1) >> 1] as number, sorted[sorted.length >> 1] as number]);
}

const WIDTH = 9;

function printHead(maxError: number): void {
  console.log(`\nmax-error ${maxError}: even and adapted; noise and bias over what was asked`);
  const names = [
    'pixels',
    'samples',
    'adapted',
    'GPU time',
    'CPU time',
    'equal',
    'noise',
    'adapted',
    'bias',
    '±',
    'turns',
    'end',
  ];
  console.log(''.padEnd(16) + names.map((name) => name.padStart(WIDTH)).join(''));
}

function print(row: Governed): void {
  const cells = [
    `${row.width}x${row.height}`,
    row.evenSamples.toFixed(0),
    row.adaptedSamples.toFixed(0),
    row.timeRatio.toFixed(2),
    row.cpuRatio.toFixed(2),
    row.equalRatio.toFixed(2),
    row.evenNoise.toFixed(2),
    row.adaptedNoise.toFixed(2),
    biasOf(row).toFixed(3),
    chanceOf(row).toFixed(3),
    row.turns.toFixed(0),
    row.reasons.join(' '),
  ];
  console.log(row.scene.padEnd(16) + cells.map((cell) => cell.padStart(WIDTH)).join(''));
}

/** How far the noise at the stop may be from what was asked. */
const TOLERANCE = 0.25;
/** What part of what was asked the bias may be. */
const MOST_BIAS = 0.1;

type SquaredBias = Pick<Governed, 'squaredBias' | 'squaredBiasError'>;

export const biasOf = ({ squaredBias }: SquaredBias): number => Math.sqrt(Math.max(0, squaredBias));

/** What chance alone makes of no bias, as large as one standard error. */
export const chanceOf = ({ squaredBiasError }: SquaredBias): number => Math.sqrt(squaredBiasError);

/** Of the mean of squares: what several scenes have together is known better than what each has. */
function pooled(rows: readonly SquaredBias[]): SquaredBias {
  return {
    squaredBias: mean(rows.map(({ squaredBias }) => squaredBias)),
    squaredBiasError: Math.hypot(...rows.map(({ squaredBiasError }) => squaredBiasError)) / rows.length,
  };
}

/** What rows of the same wish say together. */
export function stoppingOf(rows: readonly Governed[]) {
  const medianOf = (value: (row: Governed) => number): number => median(rows.map(value));
  const sideOf = ({ squaredBias, squaredBiasError }: SquaredBias): number =>
    (squaredBias - MOST_BIAS ** 2) / (2 * squaredBiasError);
  const sides = rows.map(sideOf);
  const together = pooled(rows);
  return {
    /** Medians of the time of the GPU, of that of processors, and of the latter for equal noise. */
    times: [
      medianOf(({ timeRatio }) => timeRatio),
      medianOf(({ cpuRatio }) => cpuRatio),
      medianOf(({ equalRatio }) => equalRatio),
    ],
    /** How many end with about the noise that was asked for. */
    near: rows.filter(({ adaptedNoise }) => Math.abs(adaptedNoise - 1) <= TOLERANCE).length,
    /** How many have less, since they could not end earlier. */
    early: rows.filter(
      ({ adaptedNoise, evenSamples }) => adaptedNoise < 1 - TOLERANCE && evenSamples < FEWEST_SAMPLES + 2,
    ).length,
    /** How many ended for no other reason. */
    enough: rows.filter(({ reasons }) => !reasons.includes('samples')).length,
    /** How many are sure, by two standard errors, to have a bias below the limit, or above it. */
    below: sides.filter((side) => side < -1).length,
    above: sides.filter((side) => side > 1).length,
    /** Root of the mean of the squared biases, and what it may be by two standard errors. */
    bias: biasOf(together),
    biasAtMost: Math.sqrt(Math.max(0, together.squaredBias) + 2 * together.squaredBiasError),
  };
}

function printFoot(rows: readonly Governed[]): void {
  const { times, near, early, enough, below, above, bias, biasAtMost } = stoppingOf(rows);
  const [gpu, cpu, equal] = times.map((time) => time.toFixed(2));
  console.log(`medians of GPU time ${gpu}, CPU time ${cpu}, CPU time for equal noise ${equal}`);
  console.log(
    `noise at the stop within a quarter of what was asked: ${near} of ${rows.length}; less with the fewest samples`,
  );
  console.log(`that may be: ${early}; ended by noise: ${enough}`);
  console.log(`bias by two standard errors below ${MOST_BIAS} of what was asked: ${below}, above it: ${above}`);
  console.log(`bias of all together: ${bias.toFixed(3)} of what was asked, at most ${biasAtMost.toFixed(3)}`);
}
