import { expect } from '@open-wc/testing';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { addPixels, countObjects, fillSource } from './gl-fixtures.ts';

for (const precision of ['float', 'half'] as const) {
  describe(`Accumulation (${precision})`, () => {
    let device: RenderDevice;
    let gl: WebGL2RenderingContext;
    before(() => {
      device = new RenderDevice({ precision });
      ({ gl } = device);
    });
    after(() => device.dispose());

    /** A function that adds a sample of one colour all over, in GLSL. */
    const adder = (target: Accumulation) => (color: string) => {
      const program = new Program(gl, fillSource(color));
      program.use();
      target.add(() => gl.drawArrays(gl.TRIANGLES, 0, 3));
      program.dispose();
    };

    it('gives the mean of what was added, whatever was there before', () => {
      const target = new Accumulation(gl, device.precision, 3, 2);
      const add = adder(target);
      expect(target.readMean()).to.deep.equal(new Float32Array(24));
      for (const color of ['vec4(9)', 'vec4(9)']) add(color);
      target.clear();
      expect(target.samples).to.equal(0);
      for (const color of ['vec4(1, 0.5, 0, 1)', 'vec4(2, 0.5, 0, 1)', 'vec4(3, 0.5, 0, 0)', 'vec4(6, 0.5, 0, 0)'])
        add(color);
      expect(target.samples).to.equal(4);
      const mean = target.readMean();
      for (const [i, value] of [3, 0.5, 0, 0.5].entries()) {
        expect(mean[i + 8]).to.be.closeTo(value, precision === 'float' ? 0 : 2e-3 * value);
      }
      target.dispose();
    });

    it('neither stops counting nor overflows', () => {
      const target = new Accumulation(gl, device.precision, 1, 1);
      const program = new Program(gl, fillSource('vec4(30000, 3, 1, 1)'));
      program.use();
      for (let i = 0; i < 3000; i++) target.add(() => gl.drawArrays(gl.TRIANGLES, 0, 3));
      // To the last bit of a half float, which some blending units cut off rather than round.
      const mean = target.readMean();
      for (const [i, value] of [30000, 3, 1, 1].entries()) {
        expect(mean[i]).to.be.closeTo(value, value * 2 ** -10);
      }
      program.dispose();
      target.dispose();
    });

    it('reads the top row first', () => {
      const target = new Accumulation(gl, device.precision, 2, 2);
      addPixels(gl, target, [
        [1, 0, 0, 1],
        [2, 0, 0, 1],
        [3, 0, 0, 1],
        [4, 0, 0, 1],
      ]);
      expect([...target.readMean().filter((_, i) => i % 4 === 0)]).to.deep.equal([3, 4, 1, 2]);
      target.dispose();
    });

    it('frees everything', () => {
      const counts = countObjects(gl);
      new Accumulation(gl, device.precision, 8, 8).dispose();
      expect(Object.values(counts)).to.deep.equal([0, 0, 0, 0, 0]);
    });
  });
}
