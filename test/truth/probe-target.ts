/** What probes draw into, and what their programs read from. */
import { blockBindings } from '../../packages/ray-scene/src/program.ts';

export interface FloatTarget {
  /** RGBA, the bottom row first. */
  read(): Float32Array;
  dispose(): void;
}

/** A float target, which is drawn into from now on. */
export function createTarget(gl: WebGL2RenderingContext, width: number, height: number): FloatTarget {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.disable(gl.BLEND);
  return {
    read() {
      const pixels = new Float32Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
      return pixels;
    },
    dispose() {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(texture);
    },
  };
}

/** The two uniform blocks of a program. */
export class UniformBuffers {
  readonly #gl: WebGL2RenderingContext;
  readonly #scene: WebGLBuffer;
  readonly #view: WebGLBuffer;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#scene = gl.createBuffer();
    this.#view = gl.createBuffer();
  }

  /** Of the view, only the window is drawn from, and a probe's pixel sees nothing of it: its bytes are zeros. */
  write(scene: ArrayBuffer, viewSize: number): void {
    this.#write(this.#scene, blockBindings.Scene, scene);
    this.#write(this.#view, blockBindings.View, new ArrayBuffer(viewSize));
  }

  #write(buffer: WebGLBuffer, binding: number, bytes: ArrayBuffer): void {
    const gl = this.#gl;
    if (bytes.byteLength === 0) return;
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
    gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, buffer);
  }
}
