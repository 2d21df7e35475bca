import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pixelSample } from '@ray-scene/core';
import fc from 'fast-check';
import { hash, ownPlace, pixelSampler, sample2d } from '../../packages/core/src/random.ts';

test('the hash is PCG: values worked out by hand from its definition', () => {
  // BigInt arithmetic modulo 2³², step by step as the paper writes it.
  const pcg = (v: bigint): bigint => {
    const mask = 0xffffffffn;
    const state = (v * 747796405n + 2891336453n) & mask;
    const word = (((state >> ((state >> 28n) + 4n)) ^ state) * 277803737n) & mask;
    return (word >> 22n) ^ word;
  };
  fc.assert(fc.property(fc.nat({ max: 0xffffffff }), (v) => assert.equal(hash(v), Number(pcg(BigInt(v))))));
});

test('samples lie in [0, 1)² and are exact in f32', () => {
  fc.assert(
    fc.property(fc.nat({ max: 1e6 }), fc.nat({ max: 0xffffffff }), (index, seed) => {
      for (const x of pixelSample(index, seed)) assert.ok(x >= 0 && x < 1 && Math.fround(x) === x);
    }),
  );
});

test('each half-sequence is a (0, 2)-sequence: 2^m points fall into all boxes of area 2^-m, whatever their shape', () => {
  fc.assert(
    fc.property(fc.nat({ max: 0xffffffff }), fc.integer({ min: 1, max: 8 }), fc.constantFrom(0, 1), (seed, m, half) => {
      const points = Array.from({ length: 2 ** m }, (_, i) => pixelSample(2 * i + half, seed));
      for (let a = 0; a <= m; a++) {
        const boxes = new Set(points.map(([x, y]) => `${Math.floor(x * 2 ** a)},${Math.floor(y * 2 ** (m - a))}`));
        assert.equal(boxes.size, 2 ** m);
      }
    }),
  );
});

test('other seeds, and the two halves, give other points', () => {
  assert.notDeepEqual(pixelSample(0, 0), pixelSample(0, 1));
  assert.notDeepEqual(pixelSample(0, 0), pixelSample(1, 0));
});

test('so is each of the padded sequences of a pixel', () => {
  const anywhere = fc.nat({ max: 8191 });
  fc.assert(
    fc.property(anywhere, anywhere, fc.nat({ max: 300 }), fc.integer({ min: 1, max: 8 }), (x, y, set, m) => {
      const points = Array.from({ length: 2 ** m }, (_, i) => sample2d(pixelSampler(x, y, 2 * i, 1), set));
      for (let a = 0; a <= m; a++) {
        const boxes = new Set(points.map(([u, v]) => `${Math.floor(u * 2 ** a)},${Math.floor(v * 2 ** (m - a))}`));
        assert.equal(boxes.size, 2 ** m);
      }
    }),
  );
});

test('so are the places of the samples in a pixel that has its own; those of its neighbours are other ones', () => {
  const anywhere = fc.nat({ max: 8191 });
  fc.assert(
    fc.property(anywhere, anywhere, fc.integer({ min: 1, max: 8 }), fc.constantFrom(0, 1), (x, y, m, half) => {
      const points = Array.from({ length: 2 ** m }, (_, i) => ownPlace(pixelSampler(x, y, 2 * i + half, 1)));
      for (let a = 0; a <= m; a++) {
        const boxes = new Set(points.map(([u, v]) => `${Math.floor(u * 2 ** a)},${Math.floor(v * 2 ** (m - a))}`));
        assert.equal(boxes.size, 2 ** m);
      }
      for (const [right, up] of [
        [1, 0],
        [0, 1],
      ] as const) {
        assert.notDeepEqual(ownPlace(pixelSampler(x + right, y + up, half, 1)), points[0]);
      }
    }),
  );
});

/** The root mean square error, over many pixels, of the mean of u v w z at so many points of two sets. */
function productError(points: (pixel: number, i: number) => readonly number[], count: number): number {
  const pixels = Array.from({ length: 2000 }, (_, pixel) => {
    const products = Array.from({ length: count }, (_, i) => points(pixel, i).reduce((a, b) => a * b));
    return products.reduce((a, b) => a + b) / count - 1 / 16;
  });
  return Math.sqrt(pixels.reduce((sum, error) => sum + error * error, 0) / pixels.length);
}

test('at equal samples the error of an integral over two sets is below that of plain hashing', () => {
  const fraction = (n: number): number => hash(n) / 2 ** 32;
  const hashed = (pixel: number, i: number) => [0, 1, 2, 3].map((k) => fraction(hash(pixel) + 4 * i + k));
  const padded = (pixel: number, i: number) => {
    const sampler = pixelSampler(pixel % 50, Math.floor(pixel / 50), 2 * i, 0);
    return [...sample2d(sampler, 1), ...sample2d(sampler, 2)];
  };
  const ratios = [16, 64, 256].map((count) => productError(padded, count) / productError(hashed, count));
  console.log(`error of padded Sobol points over that of hashing: ${ratios.map((r) => r.toFixed(2)).join(', ')}`);
  for (const ratio of ratios) assert.ok(ratio < 0.8, `${ratio}`);
});
