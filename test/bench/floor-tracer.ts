/** Draws with a shader of `floors/`: both stages are in one file, see the head of `floors/classic.frag`. */
import type { CameraFrame } from '@ray-scene/core';
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
  draw({ origin, corner, stepX, stepY, width, height }: CameraFrame): void {
    const gl = this.#gl;
    const [right, up] = [scale(stepX, width / 2), scale(stepY, height / 2)];
    this.#program.use();
    gl.uniform3fv(this.#program.uniform('origin'), origin);
    gl.uniform3fv(this.#program.uniform('right'), right);
    gl.uniform3fv(this.#program.uniform('up'), up);
    // The sample's place in the pixel is in `corner` already, and so in the middle of the window.
    gl.uniform3fv(this.#program.uniform('forward'), addScaled(addScaled(corner, right, 1), up, 1));
    gl.uniform2f(this.#program.uniform('jitter'), 0.5, 0.5);
    gl.uniform2f(this.#program.uniform('resolution'), width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
