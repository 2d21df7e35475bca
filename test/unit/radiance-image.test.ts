// Images in the format of Radiance: every way to write pixels, and what is none.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { readRadianceImage } from '@ray-scene/core';

const HEAD = '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n';

const file = (text: string, ...numbers: readonly number[]): Uint8Array =>
  new Uint8Array([...Buffer.from(text), ...numbers]);

const pixels = (bytes: Uint8Array): number[] => [...readRadianceImage(bytes).data];

/** Mantissas 0 and 255 of the exponent that makes steps of 1. */
const [LOW, HIGH] = [
  [0, 0, 0, 136],
  [255, 255, 255, 136],
] as const;

describe('images in the format of Radiance', () => {
  it('have mantissas of the size that the exponent says, each in the middle of its step', () => {
    const image = readRadianceImage(file(`${HEAD}-Y 1 +X 2\n`, 1, 2, 3, 136, 10, 20, 30, 129));
    assert.deepEqual([image.width, image.height], [2, 1]);
    assert.deepEqual([...image.data], [1.5, 2.5, 3.5, 10.5 / 128, 20.5 / 128, 30.5 / 128]);
  });

  it('are black where the exponent is 0, and numbers up to the largest one', () => {
    assert.deepEqual(pixels(file(`${HEAD}-Y 1 +X 1\n`, 9, 9, 9, 0)), [0, 0, 0]);
    assert.ok(pixels(file(`${HEAD}-Y 1 +X 1\n`, 255, 255, 255, 255)).every(Number.isFinite));
  });

  it('are what was there before the exposure, all exposures together', () => {
    const text = '#?RGBE\nEXPOSURE=2\n# by hand\nEXPOSURE= 4.0 \nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n';
    assert.deepEqual(pixels(file(text, 1, 2, 3, 136)), [1.5 / 8, 2.5 / 8, 3.5 / 8]);
  });

  it('may begin at any of the four corners', () => {
    const corners = ['-Y 2 +X 2', '+Y 2 +X 2', '-Y 2 -X 2', '+Y 2 -X 2'];
    const grey = (n: number): number[] => [n, n, n, 136];
    const firsts = corners.map((size) =>
      pixels(file(`${HEAD}${size}\n`, ...grey(2), ...grey(4), ...grey(6), ...grey(8))).filter((_, i) => i % 3 === 0),
    );
    assert.deepEqual(firsts, [
      [2.5, 4.5, 6.5, 8.5],
      [6.5, 8.5, 2.5, 4.5],
      [4.5, 2.5, 8.5, 6.5],
      [8.5, 6.5, 4.5, 2.5],
    ]);
  });

  it('may be packed channel by channel, in runs and in others', () => {
    const reds = [128 + 5, 7, 4, 1, 2, 3, 4];
    const rest = [128 + 9, 8];
    const bytes = file(`${HEAD}-Y 1 +X 9\n`, 2, 2, 0, 9, ...reds, ...rest, ...rest, 128 + 9, 136);
    const data = pixels(bytes);
    assert.deepEqual(
      data.filter((_, i) => i % 3 === 0),
      [7.5, 7.5, 7.5, 7.5, 7.5, 1.5, 2.5, 3.5, 4.5],
    );
    assert.ok(data.filter((_, i) => i % 3 !== 0).every((n) => n === 8.5));
  });

  it('may repeat the pixel before, in the older way', () => {
    const bytes = file(`${HEAD}-Y 1 +X 9\n`, ...HIGH, 1, 1, 1, 3, ...LOW, 1, 1, 1, 4);
    assert.deepEqual(
      pixels(bytes).filter((_, i) => i % 3 === 0),
      [255.5, 255.5, 255.5, 255.5, 0.5, 0.5, 0.5, 0.5, 0.5],
    );
    // 2 + 256 times.
    const long = pixels(file(`${HEAD}-Y 1 +X 259\n`, ...HIGH, 1, 1, 1, 2, 1, 1, 1, 1));
    assert.ok(long.length === 3 * 259 && long.every((n) => n === 255.5));
  });

  it('tell what is wrong with them', () => {
    const wrong: readonly (readonly [Uint8Array, string])[] = [
      [file('not an image\n'), 'it does not begin with "#?"'],
      [file('#?RADIANCE'), 'it ends within its header'],
      [file('#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n'), 'it has pixels as "32-bit_rle_xyze"'],
      [file(`${HEAD}+X 2 +Y 1\n`), 'it has its rows as "+X 2 +Y 1", not as "-Y height +X width"'],
      [file(`${HEAD}-Y 0 +X 9\n`), 'it has its rows as "-Y 0 +X 9", not as "-Y height +X width"'],
      [file(`${HEAD}-Y 99999 +X 99999\n`), 'it has 99999 × 99999 pixels, more than 33554432'],
      [file(`${HEAD}-Y 1 +X 2\n`, ...HIGH), 'it ends before its last row'],
      [file(`${HEAD}-Y 1 +X 8\n`, 2, 2, 0, 9), 'it has rows of 8 and of 9 pixels'],
      [file(`${HEAD}-Y 1 +X 8\n`, 2, 2, 0, 8, 128 + 9, 1), 'it has a run beyond the end of its row'],
      [file(`${HEAD}-Y 1 +X 8\n`, 2, 2, 0, 8, 0), 'it has a run beyond the end of its row'],
      [file(`${HEAD}-Y 1 +X 2\n`, 1, 1, 1, 2), 'it repeats a pixel before the first one'],
      [file(`${HEAD}-Y 1 +X 2\n`, ...HIGH, 1, 1, 1, 2), 'it has a run beyond the end of its row'],
    ];
    for (const [bytes, message] of wrong) assert.throws(() => readRadianceImage(bytes), { message });
  });

  it('are numbers or errors, whatever the bytes', () => {
    const bytes = readFileSync(new URL('../../examples/images/window.hdr', import.meta.url));
    assert.deepEqual([readRadianceImage(bytes).width, readRadianceImage(bytes).height], [256, 128]);
    for (let i = 0; i < 300; i++) {
      const damaged = Uint8Array.from(bytes.subarray(0, i % 3 === 0 ? bytes.length : 97 * i));
      damaged[(7919 * i) % damaged.length] = (31 * i) % 256;
      try {
        assert.ok(readRadianceImage(damaged).data.every(Number.isFinite));
      } catch (error) {
        assert.match((error as Error).message, /^it /);
      }
    }
  });
});
