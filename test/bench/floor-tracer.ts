/** Draws with a shader of `floors/`: both stages are in one file, see the head of `floors/classic.frag`. */
import { type CameraFrame, cameraAxes, type ResolvedCamera } from '@ray-scene/core';
import { Program } from '../../packages/ray-scene/src/program.ts';

export class FloorTracer {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: Program;
  readonly #camera: ResolvedCamera;

  constructor(gl: WebGL2RenderingContext, source: string, camera: ResolvedCamera) {
    this.#gl = gl;
    this.#camera = camera;
    this.#program = new Program(gl, {
      vertex: source.replace('\n', '\n#define VERTEX\n'),
      fragment: source,
      lines: source.split('\n').map((_, i) => ({ file: 'floor', line: i + 1 })),
    });
    this.#program.use();
  }

  /** Draws one sample of every pixel into the bound framebuffer. */
  draw({ width, height, corner, stepX, stepY }: CameraFrame): void {
    const { right, up, forward } = cameraAxes(this.#camera);
    const along = (axis: readonly number[], v: readonly number[]): number =>
      axis.reduce((sum, x, i) => sum + x * (v[i] as number), 0);
    const [perX, perY] = [along(right, stepX), along(up, stepY)];
    this.#program.use();
    this.#set('origin', this.#camera.position);
    this.#set('forward', forward);
    this.#set('right', right.map((x) => (x * perX * width) / 2));
    this.#set('up', up.map((x) => (x * perY * height) / 2));
    // Where in the pixel the sample is: pixel centres would put the corner of the window half a window from its middle.
    this.#set('jitter', [along(right, corner) / perX + width / 2 + 0.5, along(up, corner) / perY + height / 2 + 0.5]);
    this.#set('resolution', [width, height]);
    this.#gl.drawArrays(this.#gl.TRIANGLES, 0, 3);
  }

  #set(name: string, value: readonly number[]): void {
    const location = this.#program.uniform(name);
    if (value.length === 2) this.#gl.uniform2fv(location, value);
    else this.#gl.uniform3fv(location, value);
  }
}
