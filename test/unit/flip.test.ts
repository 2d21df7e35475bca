import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { flip, meanFlipTo, type ShownPicture } from '../bench/trade/flip.ts';

const [width, height] = [24, 16];

const meanFlip = (one: ShownPicture, other: ShownPicture): number => meanFlipTo(other)(one);

const picture = (colorAt: (x: number, y: number) => readonly number[]): ShownPicture => ({
  width,
  height,
  data: Array.from({ length: width * height }, (_, i) => colorAt(i % width, Math.floor(i / width))).flat(),
});

const ramp = picture((x, y) => [x / (width - 1), y / (height - 1), 0.5]);

/** The ramp with noise from -0.1 to 0.1: the upper 24 bits of a linear congruential generator. */
function noisyRamp(): ShownPicture {
  let state = 1;
  const data = Array.from(ramp.data, (value) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.min(Math.max(value + ((state >>> 8) / 2 ** 24) * 0.2 - 0.1, 0), 1);
  });
  return { width, height, data };
}

const edgeAt = (column: number): ShownPicture => picture((x) => (x < column ? [0.2, 0.2, 0.2] : [0.8, 0.8, 0.8]));

/** What the authors' program (flip-evaluator 1.7 for Python, in f32) says: the mean, and the pixel in column 12 and row 8. */
const published: readonly [string, ShownPicture, ShownPicture, number, number][] = [
  ['green and blue', picture(() => [0, 1, 0]), picture(() => [0, 0, 1]), 1, 1],
  ['black and white', picture(() => [0, 0, 0]), picture(() => [1, 1, 1]), 0.967387, 0.967388],
  ['two greys', picture(() => [0.5, 0.5, 0.5]), picture(() => [0.5, 0.52, 0.5]), 0.135507, 0.135507],
  ['a ramp with and without noise', ramp, noisyRamp(), 0.136745, 0.133869],
  ['an edge and the same one pixel on', edgeAt(12), edgeAt(13), 0.094662, 0.446751],
];

describe('FLIP', () => {
  for (const [name, one, other, mean, pixel] of published) {
    it(`says of ${name} what the program of its authors says`, () => {
      assert.ok(Math.abs(meanFlip(one, other) - mean) < 1e-4, `${meanFlip(one, other)}`);
      assert.ok(Math.abs((flip(one, other)[8 * width + 12] as number) - pixel) < 1e-3);
    });
  }

  it('finds no difference between a picture and itself', () => assert.equal(meanFlip(ramp, ramp), 0));

  it('does not care which of two comes first', () => {
    assert.ok(Math.abs(meanFlip(ramp, noisyRamp()) - meanFlip(noisyRamp(), ramp)) < 1e-12);
  });
});
