/** A texture of floats that shaders draw into. */
import type { Precision } from './render-device.ts';

export class FloatTarget {
  readonly width: number;
  readonly height: number;
  readonly texture: WebGLTexture;
  readonly isComplete: boolean;
  readonly #gl: WebGL2RenderingContext;
  readonly #framebuffer: WebGLFramebuffer;

  constructor(gl: WebGL2RenderingContext, precision: Precision, width: number, height: number) {
    this.#gl = gl;
    this.width = width;
    this.height = height;
    this.texture = gl.createTexture();
    this.#framebuffer = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, precision === 'float' ? gl.RGBA32F : gl.RGBA16F, width, height);
    FloatTarget.useNearest(gl);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    this.isComplete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
  }

  /** The default filters want mipmaps and blend texels, which floats do not do. */
  static useNearest(gl: WebGL2RenderingContext): void {
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }

  /** Makes it what is drawn into. */
  bind(): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.viewport(0, 0, this.width, this.height);
  }

  /** What it holds, the bottom row first. Waits for the GPU. */
  read(): Float32Array {
    const gl = this.#gl;
    const { width, height } = this;
    const pixels = new Float32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
    return pixels;
  }

  dispose(): void {
    this.#gl.deleteFramebuffer(this.#framebuffer);
    this.#gl.deleteTexture(this.texture);
  }
}
