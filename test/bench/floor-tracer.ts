/** Draws with a shader of `floors/`: both stages are in one file, see the head of `floors/classic.frag`. */
import { type CameraFrame, pixelSample, type SampleNumber } from '@ray-scene/core';
import { addScaled, scale } from '../../packages/core/src/vector.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';

export class FloorTracer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: Program;

  constructor(gl: WebGL2RenderingContext, source: string) {
    this.#gl = gl;
    this.#program = new Program(gl, {
      vertex: source.replace('\n', '\n#define VERTEX\n'),
      fragment: source,
      lines: source.split('\n').map((_, i) => ({ file: 'floor', line: i + 1 })),
    });
    this.#program.use();
  }

  /** Draws one sample of every pixel into the bound framebuffer. */
  draw({ origin, corner, stepX, stepY, width, height }: CameraFrame, { sample, seed }: SampleNumber): void {
    const gl = this.#gl;
    const [right, up] = [scale(stepX, width / 2), scale(stepY, height / 2)];
    this.#program.use();
    gl.uniform3fv(this.#program.uniform('origin'), origin);
    gl.uniform3fv(this.#program.uniform('right'), right);
    gl.uniform3fv(this.#program.uniform('up'), up);
    gl.uniform3fv(this.#program.uniform('forward'), addScaled(addScaled(corner, right, 1), up, 1));
    const [x, y] = pixelSample(sample, seed);
    gl.uniform2f(this.#program.uniform('jitter'), x, 1 - y);
    gl.uniform2f(this.#program.uniform('resolution'), width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
