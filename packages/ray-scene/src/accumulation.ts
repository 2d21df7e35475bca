/** The float target that the samples of one view are gathered in. How they are gathered is known here alone. */
import type { Precision } from './render-device.ts';

/**
 * In f32 samples are added up. In half float, where 2048 + 1 is 2048 and nothing exceeds 65504, the target holds the
 * running mean instead.
 */
export class Accumulation {
  readonly width: number;
  readonly height: number;
  readonly #gl: WebGL2RenderingContext;
  readonly #precision: Precision;
  readonly #texture: WebGLTexture;
  readonly #framebuffer: WebGLFramebuffer;
  #samples = 0;

  /** @throws {Error} when the target does not fit into the graphics memory. */
  constructor(gl: WebGL2RenderingContext, precision: Precision, width: number, height: number) {
    this.#gl = gl;
    this.#precision = precision;
    this.width = width;
    this.height = height;
    this.#texture = gl.createTexture();
    this.#framebuffer = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, precision === 'float' ? gl.RGBA32F : gl.RGBA16F, width, height);
    // The default filters want mipmaps and blend texels, which floats do not do.
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.#texture, 0);
    const complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
    if (complete) return;
    this.dispose();
    throw new Error(`A picture of ${width} × ${height} pixels does not fit into the graphics memory`);
  }

  /** How many samples each pixel has. */
  get samples(): number {
    return this.#samples;
  }

  /** What the contents of the texture are to be divided by. */
  get weight(): number {
    return this.#precision === 'float' ? this.#samples : 1;
  }

  /** Begins anew. */
  clear(): void {
    this.#samples = 0;
  }

  /** Adds the sample of every pixel that `draw` draws. */
  add(draw: () => void): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.viewport(0, 0, this.width, this.height);
    this.#blend();
    draw();
    this.#samples++;
  }

  /** Makes the texture the one that shaders read from unit 0. */
  bindTexture(): void {
    this.#gl.activeTexture(this.#gl.TEXTURE0);
    this.#gl.bindTexture(this.#gl.TEXTURE_2D, this.#texture);
  }

  /** The mean of the samples, RGBA, the top row first. Waits for the GPU. */
  readMean(): Float32Array {
    const gl = this.#gl;
    const { width, height, weight } = this;
    const mean = new Float32Array(4 * width * height);
    if (this.#samples === 0) return mean;
    const pixels = new Float32Array(mean.length);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
    for (let y = 0; y < height; y++) {
      const row = pixels.subarray(4 * width * y, 4 * width * (y + 1));
      mean.set(
        row.map((value) => value / weight),
        4 * width * (height - 1 - y),
      );
    }
    return mean;
  }

  dispose(): void {
    this.#gl.deleteFramebuffer(this.#framebuffer);
    this.#gl.deleteTexture(this.#texture);
  }

  #blend(): void {
    const gl = this.#gl;
    if (this.#samples === 0) {
      // The first sample replaces what was there before.
      gl.disable(gl.BLEND);
      return;
    }
    gl.enable(gl.BLEND);
    if (this.#precision === 'float') {
      gl.blendFunc(gl.ONE, gl.ONE);
    } else {
      gl.blendColor(0, 0, 0, 1 / (this.#samples + 1));
      gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    }
  }
}
