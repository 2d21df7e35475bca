// The judging of pictures, on pictures whose errors are known.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { type Estimate, estimate } from '../truth/images/estimate.ts';
import type { ImageTruth } from '../truth/images/image-truth.ts';
import { imageRow } from '../truth/images/judge-image.ts';
import type { NeutralScene } from '../truth/images/neutral-scene.ts';
import { png } from '../truth/images/png.ts';
import { normalRandom } from './normal-random.ts';

const SIZE = 64;
const PIXELS = SIZE * SIZE;

const scene = { name: 'made up' } as NeutralScene;

/** A picture of what is ½ everywhere, with noise of that standard error in it, from 16 batches. */
function theirs(error: number, seed = 1): ImageTruth {
  const random = normalRandom(seed);
  const mean = Array.from({ length: PIXELS }, () => 0.5 + error * random());
  return {
    scene,
    width: SIZE,
    height: SIZE,
    batches: 16,
    rgb: Float32Array.from({ length: 3 * PIXELS }, (_, i) => mean[Math.floor(i / 3)] as number),
    error: new Float32Array(PIXELS).fill(error),
    meanError: error / 0.5 / SIZE,
  };
}

/** Renders noise: of each batch's pixels, `noise` / √samples around `value`. */
const noiseOf =
  (noise: number, value = 0.5) =>
  async (seed: number, samples: number): Promise<Float64Array> => {
    const random = normalRandom(1000 + seed);
    const mean = Array.from({ length: PIXELS }, () => value + (noise / Math.sqrt(samples)) * random());
    return Float64Array.from({ length: 3 * PIXELS }, (_, i) => mean[Math.floor(i / 3)] as number);
  };

const estimated = (noise: number, value?: number): Promise<Estimate> =>
  estimate(noiseOf(noise, value), { more: () => 1, mostSamples: 2 ** 20 });

test('two pictures of the same agree, as surely as their errors say', async () => {
  const row = imageRow('reference', await estimated(0.1), theirs(0.01));
  assert.deepEqual(row.broken, []);
  // Ours have 128 samples.
  assert.ok(Math.abs((row.errorRatio ?? 0) - 0.1 / Math.sqrt(128) / 0.01) < 0.05, `${row.errorRatio}`);
  assert.ok(Math.abs((row.rmsZ ?? 0) - 1) < 0.1, `${row.rmsZ}`);
  assert.equal(row.noisyFraction, 1);
  assert.equal(row.skippedFraction, 0);
});

test('a picture that is brighter by a hundredth is found out', async () => {
  const { broken, bias } = imageRow('gpu', await estimated(0.01, 0.505), theirs(0.001));
  assert.ok(Math.abs((bias ?? 0) - 0.01) < 1e-4);
  assert.equal(broken.length, 2, broken.join('\n'));
});

test('errors that are larger or smaller than they are said to be are found out', async () => {
  const ours = await estimated(0.1);
  for (const factor of [0.5, 2]) {
    const wrong = { ...ours, error: ours.error.map((error) => factor * error) };
    const { broken } = imageRow('gpu', wrong, theirs(0.0001));
    assert.ok(broken.some((what) => what.startsWith('rmsZ')));
  }
});

test('pixels without noise say nothing of it: with them, what is off by more than its errors would pass', async () => {
  const [noisy, truth] = [await estimated(0.1), theirs(0.01)];
  const isStill = (pixel: number): boolean => pixel % 2 === 0;
  const rgb = (values: ArrayLike<number>) =>
    Float64Array.from(values, (x, i) => (isStill(Math.floor(i / 3)) ? 0.5 : x));
  const error = (values: ArrayLike<number>, factor = 1) =>
    Float64Array.from(values, (x, i) => (isStill(i) ? 0 : factor * x));
  const half = { ...truth, rgb: new Float32Array(rgb(truth.rgb)), error: new Float32Array(error(truth.error)) };
  const rowOf = (factor: number) =>
    imageRow(
      'gpu',
      { ...noisy, rgb: rgb(noisy.rgb), error: error(noisy.error, factor) },
      {
        ...half,
        error: half.error.map((x) => factor * x),
      },
    );
  const right = rowOf(1);
  assert.deepEqual(right.broken, []);
  assert.equal(right.noisyFraction, 0.5);
  assert.ok(Math.abs((right.rmsZAll ?? 0) / (right.rmsZ ?? 0) - Math.SQRT1_2) < 1e-6);
  for (const factor of [0.8, 1.25]) assert.ok(rowOf(factor).broken.some((what) => what.startsWith('rmsZ')));
});

test('pictures without noise agree where their digits do', async () => {
  const exact = { ...theirs(0), rgb: new Float32Array(3 * PIXELS).fill(0.5) };
  assert.deepEqual(imageRow('gpu', await estimated(0, 0.5 * (1 + 1e-6)), exact).broken, []);
  assert.equal(imageRow('gpu', await estimated(0, 0.5 * (1 + 1e-4)), exact).broken.length, 1);
});

test('a pixel that is not a number is left out, and told', async () => {
  const ours = await estimated(0.1);
  ours.rgb[7] = Number.NaN;
  const row = imageRow('gpu', ours, theirs(0.01));
  assert.equal(row.skippedFraction, 1 / PIXELS);
  assert.ok(Number.isFinite(row.rmsZ) && Number.isFinite(row.bias) && Number.isFinite(row.psnr));
  assert.equal(row.broken.length, 1);
});

test('as many samples are taken as the errors ask for, no seed twice', async () => {
  const seeds: number[] = [];
  const render = noiseOf(1);
  const ours = await estimate(
    (seed, samples) => {
      seeds.push(seed);
      return render(seed, samples);
    },
    { more: ({ error }) => ((error[0] as number) / 0.01) ** 2, mostSamples: 2 ** 20 },
  );
  assert.ok((ours.error[0] as number) <= 0.01);
  assert.ok(ours.samples < 2 ** 16, `${ours.samples}`);
  assert.equal(new Set(seeds).size, seeds.length);
});

test('no more samples are taken than are allowed', async () => {
  const { samples } = await estimate(noiseOf(1), { more: () => 100, mostSamples: 4096 });
  assert.equal(samples, 4096);
});

test('a PNG file holds its rows', () => {
  const file = png(2, 1, Uint8Array.from([1, 2, 3, 4, 5, 6]));
  const start = file.indexOf('IDAT') + 4;
  const data = inflateSync(file.subarray(start, start + file.readUInt32BE(start - 8)));
  assert.deepEqual([...data], [0, 1, 2, 3, 4, 5, 6]);
  // The check sum of an end without data is known.
  assert.equal(file.readUInt32BE(file.length - 4), 0xae426082);
});
