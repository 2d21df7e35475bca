/**
 * `npm run bench -- --adaptive`: what it brings that samples go where the error is, and how far the noise at the stop is
 * from what was asked for. Every scene is drawn again and again with `max-error`, evenly and adapted, each time with other
 * random numbers: how pictures that were made alike differ is their true noise, and how the two kinds differ in the mean
 * is what adapting has biased.
 */
import type { RenderSettings } from '@ray-scene/core';
import type { BenchBrowser, BenchPage } from './browser-pages.ts';
import type { Stop } from './governed-page.ts';

declare const governed: typeof import('./governed-page.ts');

/** The module of the pages that this runs in. */
export const GOVERNED_PAGE = { entry: 'test/bench/governed-page.ts', name: 'governed' } as const;

/** 40 cells. */
const SIZE = { width: 256, height: 160 };
/** Pictures of each kind: half of them in either sum. */
const EACH = 2;

export interface Governed {
  readonly scene: string;
  readonly maxError: number;
  /** True noise over what was asked for, at the stop. */
  readonly evenNoise: number;
  readonly adaptedNoise: number;
  /** Samples per pixel, in the mean. */
  readonly evenSamples: number;
  readonly adaptedSamples: number;
  /** GPU time of adapted pictures over that of even ones. */
  readonly timeRatio: number;
  /** What adapting has biased, over what was asked for; and by how much it may be wrong. */
  readonly bias: number;
  readonly biasError: number;
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

async function measureScene(page: BenchPage, scene: string, maxError: number, settings: Partial<RenderSettings>) {
  const stop = (adapts: boolean, seed: number, sum: number, more: Partial<RenderSettings> = {}): Promise<Stop> =>
    page.execute((task) => governed.stop(task), {
      ...SIZE,
      scene,
      settings: { ...settings, seed, ...more },
      adapts,
      sum,
    });
  // Drivers compile again for what they meet first, as adding to what is there.
  await stop(true, 1000, 0, { samples: 20 });
  await page.execute(() => governed.begin(), undefined);
  const turns = { even: [] as Turn[], adapted: [] as Turn[] };
  for (let i = 0; i < 2 * EACH; i++) {
    for (const adapts of i % 2 === 0 ? [false, true] : [true, false]) {
      const sum = (adapts ? 2 : 0) + (i % 2);
      const { reason, stats, gpuMs } = await stop(adapts, 2 * i + Number(adapts), sum);
      const turn = { ms: gpuMs, reason, samples: stats.rays / (SIZE.width * SIZE.height) };
      turns[adapts ? 'adapted' : 'even'].push(turn);
    }
  }
  const { noise, squaredBias } = await page.execute((each) => governed.judge(each), EACH);
  // The product of the two differences, each of the variance of four pictures, over as many values.
  const biasError = noise[0] * Math.sqrt(2 / EACH) * (3 * SIZE.width * SIZE.height) ** -0.25;
  return {
    evenNoise: noise[0] / maxError,
    adaptedNoise: noise[1] / maxError,
    evenSamples: mean(turns.even.map((turn) => turn.samples)),
    adaptedSamples: mean(turns.adapted.map((turn) => turn.samples)),
    timeRatio: mean(turns.adapted.map(({ ms }) => ms)) / mean(turns.even.map(({ ms }) => ms)),
    bias: Math.sqrt(Math.max(0, squaredBias)) / maxError,
    biasError: biasError / maxError,
    reasons: [...new Set([...turns.even, ...turns.adapted].map(({ reason }) => reason))],
  };
}

interface Turn {
  readonly ms: number;
  readonly samples: number;
  readonly reason: string;
}

const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;

const median = (values: readonly number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1] as number;

const WIDTH = 11;

function printHead(maxError: number): void {
  console.log(
    `\nmax-error ${maxError} at ${SIZE.width} × ${SIZE.height}: even and adapted; noise and bias over what was asked`,
  );
  const names = ['samples', 'adapted', 'time ratio', 'noise', 'adapted', 'bias', '±', 'end'];
  console.log(''.padEnd(16) + names.map((name) => name.padStart(WIDTH)).join(''));
}

function print(row: Governed): void {
  const cells = [
    row.evenSamples.toFixed(0),
    row.adaptedSamples.toFixed(0),
    row.timeRatio.toFixed(2),
    row.evenNoise.toFixed(2),
    row.adaptedNoise.toFixed(2),
    row.bias.toFixed(3),
    row.biasError.toFixed(3),
    row.reasons.join(' '),
  ];
  console.log(row.scene.padEnd(16) + cells.map((cell) => cell.padStart(WIDTH)).join(''));
}

/** How far the noise at the stop may be from what was asked. */
const TOLERANCE = 0.25;

function printFoot(rows: readonly Governed[]): void {
  const near = rows.filter(({ adaptedNoise }) => Math.abs(adaptedNoise - 1) <= TOLERANCE).length;
  const enough = rows.filter(({ reasons }) => !reasons.includes('samples')).length;
  console.log(`median time ratio ${median(rows.map(({ timeRatio }) => timeRatio)).toFixed(2)}`);
  console.log(`noise at the stop within a quarter of what was asked: ${near} of ${rows.length}, ${enough} ended by it`);
}
