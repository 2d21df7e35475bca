// Random numbers are the same bits on the GPU as in the reference.
import { expect } from '@open-wc/testing';
import { pathFiles } from '../../packages/core/src/path-files.ts';
import { pixelSampler, reverseBits, sample2d, sequenceSeed } from '../../packages/core/src/random.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { createTarget } from '../truth/probe-target.ts';
import { fillSource } from './gl-fixtures.ts';

const SIZE = 32;

describe('random numbers', () => {
  it('are equal bit for bit, whatever the pixel, the sample, the seed and the set', () => {
    const { gl } = RenderDevice.shared;
    for (const [sample, seed, set] of [
      [0, 0, 0],
      [1, 0, 3],
      [2, 7, 1],
      [4095, 0xffffffff, 258],
      [2 ** 20 - 1, 123456789, 17],
      // That of places in the pixel.
      [5, 3, 0xffffffff],
    ] as const) {
      const numbers = `pixelSampler(${sequenceSeed(sample, seed)}u, ${reverseBits(sample >>> 1)}u)`;
      const source = fillSource(`vec4(sample2d(${numbers}, ${set}u), 0.0, 1.0)`);
      const fragment = source.fragment.replace(
        'out vec4',
        `precision highp int;\n${pathFiles['sampler.glsl']}\nout vec4`,
      );
      const program = new Program(gl, { ...source, fragment });
      const target = createTarget(gl, SIZE, SIZE);
      gl.viewport(0, 0, SIZE, SIZE);
      program.use();
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const pixels = target.read();
      const expected = Array.from({ length: SIZE * SIZE }, (_, i) =>
        sample2d(pixelSampler(i % SIZE, Math.floor(i / SIZE), sample, seed), set),
      );
      expect(expected.map((_, i) => [...pixels.subarray(4 * i, 4 * i + 2)])).to.deep.equal(expected);
      target.dispose();
      program.dispose();
    }
  });
});
