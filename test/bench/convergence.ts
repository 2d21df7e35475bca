/**
 * How fast pictures by the integrator `path` come to rest: relMSE against converged ones, by number of samples, and the
 * slope of that in double logarithms. Beside it what three-gpu-pathtracer had on the classic.
 */
import { parseSettings } from '@ray-scene/core';
import type { Gpu } from '../truth/gpu-side.ts';

/** Samples per pixel, and of how many independent pictures the mean is taken. */
const STEPS: readonly (readonly [samples: number, pictures: number])[] = [
  [1, 16],
  [4, 8],
  [16, 4],
  [64, 2],
];

/** Of each of the two pictures that are taken as converged. */
const CONVERGED = 1024;

/** Width and height. */
const SIZE = 64;

/** As of `stats.error`: a pixel darker than the square root of this counts by its difference. */
const EPSILON = 0.01;

/** three-gpu-pathtracer 0.0.26, the classic, at the same counts. */
export const THREE_GPU_PATHTRACER = [0.315, 0.065, 0.046, 0.0076] as const;

export interface Convergence {
  /** By the counts of `samples`. */
  readonly relMse: readonly number[];
  /** The same without the thousandth of the pixels' channels that is off most: what is left without rare bright specks. */
  readonly withoutSpecks: readonly number[];
  readonly samples: readonly number[];
  /** Of log relMSE over log samples, by least squares: -1 is what independent samples have. */
  readonly slope: number;
}

export async function measureConvergence(gpu: Gpu, scene: string): Promise<Convergence> {
  const { bounces } = parseSettings();
  await gpu.show({ scene, bounces, width: SIZE, height: SIZE });
  // What is off in one of them is not off in the other: the mean of the product of differences from both is no larger for it.
  const [a, b] = [await gpu.samples(1, CONVERGED), await gpu.samples(2, CONVERGED)];
  const relMse: number[] = [];
  const withoutSpecks: number[] = [];
  let seed = 3;
  for (const [samples, pictures] of STEPS) {
    let [all, most] = [0, 0];
    for (let i = 0; i < pictures; i++) {
      const squares = relativeSquares(await gpu.samples(seed++, samples), a, b);
      all += mean(squares) / pictures;
      most += mean(squares.sort().subarray(0, Math.floor(0.999 * squares.length))) / pictures;
    }
    relMse.push(all);
    withoutSpecks.push(most);
  }
  const samples = STEPS.map(([count]) => count);
  return { samples, relMse, withoutSpecks, slope: slopeOf(samples.map(Math.log), relMse.map(Math.log)) };
}

/** Of every pixel and channel the squared difference over the square of what is right, and a bit. */
const relativeSquares = (picture: Float64Array, a: Float64Array, b: Float64Array): Float64Array =>
  picture.map((value, i) => {
    const [x, y] = [a[i] as number, b[i] as number];
    return ((value - x) * (value - y)) / (((x + y) / 2) ** 2 + EPSILON);
  });

const mean = (values: ArrayLike<number>): number =>
  Array.from(values).reduce((sum, value) => sum + value, 0) / values.length;

function slopeOf(x: readonly number[], y: readonly number[]): number {
  const [x0, y0] = [mean(x), mean(y)];
  return mean(x.map((value, i) => (value - x0) * ((y[i] as number) - y0))) / mean(x.map((value) => (value - x0) ** 2));
}

export function printConvergenceHead(): void {
  const counts = STEPS.map(([samples]) => `${samples}`.padStart(11)).join('');
  console.log(
    `\nrelMSE of ${SIZE} × ${SIZE} pixels by samples per pixel, integrator path\n${''.padEnd(24)}${counts}      slope`,
  );
}

export function printConvergence(name: string, { relMse, withoutSpecks, slope }: Convergence): void {
  console.log(`${row(name, relMse)}${slope.toFixed(2).padStart(11)}`);
  console.log(row('  without specks', withoutSpecks));
  if (name === 'classic') console.log(row('  three-gpu-pathtracer', THREE_GPU_PATHTRACER));
}

const row = (name: string, values: readonly number[]): string =>
  name.padEnd(24) + values.map((value) => value.toPrecision(3).padStart(11)).join('');
