/** The float targets that the samples of one view are gathered in. How they are gathered is known here alone. */
import { CELL_BITS, Cells, type Tile } from './cells.ts';
import { FloatTarget } from './float-target.ts';
import type { Program } from './program.ts';
import type { Precision } from './render-device.ts';

/** What `accumulated.glsl` includes. */
export const accumulationFiles = { 'generated/cells.glsl': `const int CELL_BITS = ${CELL_BITS};\n` } as const;

/**
 * Samples with even and with odd numbers are gathered apart: they are independent, so that the difference of their means
 * tells the error of both. In f32 they are added up. In half float, where 2048 + 1 is 2048 and nothing exceeds 65504, a
 * target holds the running mean instead.
 */
export class Accumulation {
  readonly width: number;
  readonly height: number;
  readonly cells: Cells;
  readonly #gl: WebGL2RenderingContext;
  readonly #precision: Precision;
  readonly #halves: readonly [FloatTarget, FloatTarget];
  readonly #weights: WebGLTexture;
  /** Whether the texture of weights is that of the present counts. */
  #weighed = false;

  /** @throws {Error} when the targets do not fit into the graphics memory. */
  constructor(gl: WebGL2RenderingContext, precision: Precision, width: number, height: number) {
    this.#gl = gl;
    this.#precision = precision;
    this.width = width;
    this.height = height;
    this.cells = new Cells(width, height);
    this.#weights = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.#weights);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, this.cells.columns, this.cells.rows);
    FloatTarget.useNearest(gl);
    const even = new FloatTarget(gl, precision, width, height);
    const odd = new FloatTarget(gl, precision, width, height);
    this.#halves = [even, odd];
    if (even.isComplete && odd.isComplete) return;
    this.dispose();
    throw new Error(`A picture of ${width} × ${height} pixels does not fit into the graphics memory`);
  }

  /** How many samples each pixel has, at least. */
  get samples(): number {
    return this.cells.least;
  }

  /** Begins anew. */
  clear(): void {
    this.cells.clear();
    this.#weighed = false;
  }

  /**
   * Adds the sample that `draw` draws of every pixel, or only of those in some tiles, once for each of them. Its number is
   * the count of the tiles, which have equally many.
   */
  add(draw: () => void, tiles: readonly Tile[] = [this.cells.whole]): void {
    const gl = this.#gl;
    const index = this.cells.countOf(tiles[0] as Tile);
    (this.#halves[index & 1] as FloatTarget).bind();
    this.#blend(index >> 1);
    gl.enable(gl.SCISSOR_TEST);
    for (const tile of tiles) {
      gl.scissor(...this.cells.rectangleOf(tile));
      draw();
      this.cells.add(tile);
    }
    gl.disable(gl.SCISSOR_TEST);
    this.#weighed = false;
  }

  /** Gives the program in use what `accumulated.glsl` reads. */
  bindTextures(program: Program): void {
    const gl = this.#gl;
    const [even, odd] = this.#halves;
    const textures = { even: even.texture, odd: odd.texture, weights: this.#weights };
    for (const [unit, [name, texture]] of Object.entries(textures).entries()) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(program.uniform(name), unit);
    }
    if (!this.#weighed) this.#weigh();
  }

  /** The mean of the samples, RGBA, the top row first; zeros where there are none. Waits for the GPU. */
  readMean(): Float32Array {
    const { width, height, cells } = this;
    const mean = new Float32Array(4 * width * height);
    const [even, odd] = this.#halves.map((half) => half.read()) as [Float32Array, Float32Array];
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const count = cells.counts[(y >> CELL_BITS) * cells.columns + (x >> CELL_BITS)] as number;
        const [a, b] = this.#factors(count);
        const from = 4 * (width * y + x);
        const to = 4 * (width * (height - 1 - y) + x);
        for (let i = 0; i < 4 && a > 0; i++) {
          // What the second half holds before its first sample is anything.
          mean[to + i] = (a * (even[from + i] as number) + (b > 0 ? b * (odd[from + i] as number) : 0)) / count;
        }
      }
    }
    return mean;
  }

  dispose(): void {
    for (const half of this.#halves) half.dispose();
    this.#gl.deleteTexture(this.#weights);
  }

  /** What the halves are to be multiplied by to be the sums of their samples, where there are `count` in both. */
  #factors(count: number): readonly [number, number] {
    const [even, odd] = [(count + 1) >> 1, count >> 1];
    return this.#precision === 'half' ? [even, odd] : [Math.min(even, 1), Math.min(odd, 1)];
  }

  #weigh(): void {
    const gl = this.#gl;
    const { columns, rows, counts } = this.cells;
    const texels = new Float32Array(4 * columns * rows);
    for (const [i, count] of counts.entries()) {
      if (count === 0) continue;
      const [even, odd] = this.#factors(count);
      texels.set([even / count, odd / count, ((count + 1) >> 1) / count, count], 4 * i);
    }
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, columns, rows, gl.RGBA, gl.FLOAT, texels);
    this.#weighed = true;
  }

  /** @param index number of the sample within its half. */
  #blend(index: number): void {
    const gl = this.#gl;
    if (index === 0) {
      // The first sample replaces what was there before.
      gl.disable(gl.BLEND);
      return;
    }
    gl.enable(gl.BLEND);
    if (this.#precision === 'float') {
      gl.blendFunc(gl.ONE, gl.ONE);
    } else {
      gl.blendColor(0, 0, 0, 1 / (index + 1));
      gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    }
  }
}
