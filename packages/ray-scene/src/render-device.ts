/** The WebGL of a page: one context, its programs, its loss and return. All views draw through it. */
import type { ShaderOptions } from '@ray-scene/core';
import { GpuClock } from './gpu-clock.ts';
import { ProgramCache } from './program-cache.ts';

/** Of the targets that samples are gathered in: 32-bit floats, or 16-bit ones where the GPU has no better. */
export type Precision = 'float' | 'half';

/** There is no WebGL2 to draw with. The message is for the author and the reader of a page. */
export class WebGLUnavailableError extends Error {
  override readonly name = 'WebGLUnavailableError';

  constructor(reason: string) {
    super(
      `This picture needs WebGL 2, and the browser does not provide it: ${reason}. Hardware acceleration may be ` +
        'switched off, or the browser or the graphics driver may be too old.',
    );
  }
}

/** What a view hears from its device. */
export interface DeviceView {
  /** Everything it made on the GPU is gone. `suspect`: it was its work that the GPU was at. */
  contextLost(suspect: boolean): void;
  /** Drawing works again. */
  contextRestored(): void;
}

export interface RenderDeviceOptions {
  /** `half` asks for half floats even where there are better. */
  readonly precision?: Precision;
}

export class RenderDevice {
  static #shared: RenderDevice | undefined;

  /**
   * The device of the page, made when first asked for. Browsers keep few contexts alive: a page needs only this one.
   * @throws {WebGLUnavailableError}
   */
  static get shared(): RenderDevice {
    RenderDevice.#shared ??= new RenderDevice();
    return RenderDevice.#shared;
  }

  readonly gl: WebGL2RenderingContext;
  readonly programs: ProgramCache;
  readonly clock: GpuClock;
  /** The largest width and height of a picture. */
  readonly maxSize: number;
  readonly precision: Precision;
  /** How shaders should be made for whoever draws here. */
  readonly shaderOptions: ShaderOptions;
  // An element rather than an OffscreenCanvas, on which WebKit has no WebGL2.
  readonly #canvas = document.createElement('canvas');
  readonly #views = new Set<DeviceView>();

  /** @throws {WebGLUnavailableError} */
  constructor({ precision = 'float' }: RenderDeviceOptions = {}) {
    this.gl = createContext(this.#canvas);
    this.programs = new ProgramCache(this.gl);
    this.clock = new GpuClock(this.gl);
    this.maxSize = Math.min(this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE), ...maxViewport(this.gl));
    this.precision = enableFloatTargets(this.gl, precision);
    this.shaderOptions = { varyings: isSoftware(this.gl) ? this.gl.getParameter(this.gl.MAX_VARYING_VECTORS) : 0 };
    this.#canvas.addEventListener('webglcontextlost', this.#onLost);
    this.#canvas.addEventListener('webglcontextrestored', this.#onRestored);
  }

  /** How many programs were compiled so far. */
  get compileCount(): number {
    return this.programs.compileCount;
  }

  add(view: DeviceView): void {
    this.#views.add(view);
  }

  remove(view: DeviceView): void {
    this.#views.delete(view);
    if (this.#views.size === 0) this.#resize(1, 1);
  }

  /**
   * Shows what `draw` draws into the lower left `width` × `height` pixels on another canvas, within this task: the
   * drawing buffer does not outlast it. The device's own canvas is as large as the largest view, since every change of
   * its size allocates it anew.
   */
  present(target: CanvasRenderingContext2D, width: number, height: number, draw: () => void): void {
    const { gl } = this;
    this.#resize(Math.max(width, this.#canvas.width), Math.max(height, this.#canvas.height));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.disable(gl.BLEND);
    draw();
    const { canvas } = target;
    // Setting a size clears the canvas, so it waits until there is something to show instead.
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    target.globalCompositeOperation = 'copy';
    target.drawImage(this.#canvas, 0, this.#canvas.height - height, width, height, 0, 0, width, height);
  }

  /** Gives the context back to the browser. Views of this device draw no more. */
  dispose(): void {
    this.#canvas.removeEventListener('webglcontextlost', this.#onLost);
    this.#canvas.removeEventListener('webglcontextrestored', this.#onRestored);
    this.clock.reset();
    this.programs.dispose();
    this.#views.clear();
    // Without this a context lives on until garbage is collected, and counts against the browser's limit.
    this.gl.getExtension('WEBGL_lose_context')?.loseContext();
    if (RenderDevice.#shared === this) RenderDevice.#shared = undefined;
  }

  #resize(width: number, height: number): void {
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
  }

  readonly #onLost = (event: Event): void => {
    // A loss that nobody objects to is for ever.
    event.preventDefault();
    const suspect = this.clock.busyWith;
    this.clock.reset();
    this.programs.clear();
    for (const view of this.#views) view.contextLost(view === suspect);
  };

  readonly #onRestored = (): void => {
    enableFloatTargets(this.gl, this.precision);
    for (const view of this.#views) view.contextRestored();
  };
}

function createContext(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  let reason = 'it gives no reason';
  const onError = (event: Event): void => {
    reason = (event as WebGLContextEvent).statusMessage || reason;
  };
  canvas.addEventListener('webglcontextcreationerror', onError);
  // All that is ever drawn is one triangle over everything; a picture that is complete takes no power.
  const gl = canvas.getContext('webgl2', {
    antialias: false,
    depth: false,
    stencil: false,
    powerPreference: 'high-performance',
  });
  canvas.removeEventListener('webglcontextcreationerror', onError);
  if (!gl) throw new WebGLUnavailableError(reason);
  return gl;
}

const maxViewport = (gl: WebGL2RenderingContext): Int32Array => gl.getParameter(gl.MAX_VIEWPORT_DIMS);

/** Enables drawing into float targets, as precise as wanted and possible; returns how precise that is. */
function enableFloatTargets(gl: WebGL2RenderingContext, wanted: Precision): Precision {
  const float = gl.getExtension('EXT_color_buffer_float');
  if (wanted === 'float' && float && gl.getExtension('EXT_float_blend')) return 'float';
  if (float || gl.getExtension('EXT_color_buffer_half_float')) return 'half';
  throw new WebGLUnavailableError('it draws into no floating-point targets');
}

/** Whether the processor draws, as far as the browser tells. */
function isSoftware(gl: WebGL2RenderingContext): boolean {
  let name: string = gl.getParameter(gl.RENDERER);
  // Chromium says it in an extension only. Firefox says it at once, and warns whoever asks for the extension.
  const extension = name === 'WebKit WebGL' ? gl.getExtension('WEBGL_debug_renderer_info') : null;
  if (extension) name = gl.getParameter(extension.UNMASKED_RENDERER_WEBGL);
  return /SwiftShader|llvmpipe|softpipe|software|Basic Render/i.test(name);
}
