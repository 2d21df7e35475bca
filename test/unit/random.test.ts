import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pixelSample } from '@ray-scene/core';
import fc from 'fast-check';
import { hash } from '../../packages/core/src/random.ts';

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
