/** `ray-scene/renderer`: draws scenes on canvases, without any element. */
import {
  cameraFrame,
  loadPaths,
  loadShaderParts,
  loadShapes,
  pixelSample,
  type RenderSettings,
  type Requirements,
  type ResolvedCamera,
  requirementsKey,
  type Scene,
} from '@ray-scene/core';
import { Accumulation } from './accumulation.ts';
import { Display } from './display.ts';
import { type DeviceView, type Precision, RenderDevice } from './render-device.ts';
import { Tracer } from './tracer.ts';
import { View } from './view.ts';

export { ShaderError } from './program.ts';
export { type Precision, RenderDevice, type RenderDeviceOptions, WebGLUnavailableError } from './render-device.ts';

/** Two losses within this time of each other, both during its work, and a scene is not tried a third time. */
const SUSPICION_MS = 60_000;

/** A scene that the GPU gave up on twice. It is not drawn any more, for the sake of the others on the page. */
export class QuarantineError extends Error {
  override readonly name = 'QuarantineError';

  constructor() {
    super(
      'Twice the graphics card gave up while it drew this scene, so it is not tried again. ' +
        'A smaller picture, fewer objects or fewer bounces may do.',
    );
  }
}

export interface RenderStats {
  /** Samples that each pixel has. */
  readonly samples: number;
  /** Programs that this renderer had compiled, and how long it waited for them. */
  readonly compiles: number;
  readonly compileMs: number;
  /** Estimate of the time that the GPU takes for one sample of every pixel; 0: not known yet. */
  readonly msPerSample: number;
  /** Of the picture, in pixels. */
  readonly width: number;
  readonly height: number;
  readonly precision: Precision;
}

/** A view of a scene. Everything on the GPU is made when it is first needed, and again after a loss of the context. */
export class Renderer {
  /** Told of what goes wrong while drawing; by default it becomes an uncaught error of the page. */
  onerror: (error: Error) => void = (error) => reportError(error);
  /** Told when the picture should be drawn again: a lost context is back, or what the scene waited for is there. */
  onrestored: () => void = () => {};

  readonly #device: RenderDevice;
  readonly #context: CanvasRenderingContext2D;
  readonly #view = new View();
  readonly #listener: DeviceView = {
    contextLost: (suspect) => this.#contextLost(suspect),
    contextRestored: () => this.onrestored(),
  };
  #hasScene = false;
  /** What was asked for last. */
  #next: Scene | undefined;
  /** The parts of its shader that the scene waits for. */
  #loading: Promise<unknown> | undefined;
  #tracer: Tracer | undefined;
  #display: Display | undefined;
  #accumulation: Accumulation | undefined;
  /** Which revision of the view the samples are of. */
  #drawn = -1;
  #presented = false;
  /** Replaced when another program or size makes earlier measurements worthless. */
  #pace = { msPerSample: 0 };
  #compiles = 0;
  #compileMs = 0;
  #lastLoss = Number.NEGATIVE_INFINITY;
  /** The key of a scene that must not be drawn any more. */
  #quarantined: string | undefined;
  /** The revision of the view that could not be drawn, and why. */
  #failed = -1;
  #failure = '';

  /**
   * @param canvas takes the pictures, and their size; it may have no context other than 2D.
   * @throws {WebGLUnavailableError} when no device is given and the page can have none.
   */
  constructor(canvas: HTMLCanvasElement, device: RenderDevice = RenderDevice.shared) {
    const context = canvas.getContext('2d');
    if (!context) throw new TypeError('The canvas has a context other than 2D already');
    this.#context = context;
    this.#device = device;
    device.add(this.#listener);
  }

  /** The scene to draw; one with shapes that the page has not loaded yet takes its place when they are there. */
  setScene(scene: Scene): void {
    this.#next = scene;
    const loading = loadShapes(scene);
    if (!loading) this.#show(scene);
    loading?.then(
      () => {
        if (this.#next !== scene) return;
        this.#show(scene);
        this.onrestored();
      },
      (error: Error) => this.onerror(error),
    );
  }

  setSettings(settings: RenderSettings): void {
    this.#view.settings = settings;
    this.#presented = false;
  }

  /** Replaces the scene's camera, as controls do, until it is set to undefined. */
  setCamera(camera: ResolvedCamera | undefined): void {
    this.#view.override = camera;
  }

  /** The camera in use. */
  get camera(): ResolvedCamera {
    return this.#view.camera;
  }

  /** In device pixels; more than the GPU can draw is made smaller in proportion. */
  resize(width: number, height: number): void {
    const shrink = Math.min(1, this.#device.maxSize / Math.max(width, height));
    this.#view.resize(Math.max(1, Math.round(width * shrink)), Math.max(1, Math.round(height * shrink)));
  }

  /**
   * Adds samples to the picture for about as long as the budget lasts, at least one unless it has all, and shows it.
   * Returns whether it wants more. Never throws: see `onerror`.
   */
  draw(budgetMs: number): boolean {
    if (!this.#isDrawable()) return false;
    try {
      const wantsMore = this.#advance(budgetMs);
      this.#failure = '';
      return wantsMore;
    } catch (error) {
      // What fails because the context was lost just now is done again when it is back.
      if (!this.#device.gl.isContextLost()) this.#fail(error as Error);
      return false;
    }
  }

  /** Samples that each pixel of the present scene has. */
  get samples(): number {
    return this.#drawn === this.#view.revision ? (this.#accumulation?.samples ?? 0) : 0;
  }

  get stats(): RenderStats {
    return {
      samples: this.samples,
      compiles: this.#compiles,
      compileMs: this.#compileMs,
      msPerSample: this.#pace.msPerSample,
      width: this.#view.width,
      height: this.#view.height,
      precision: this.#device.precision,
    };
  }

  /** The mean of the samples: linear radiance RGBA premultiplied, the top row first. Zeros before the first draw. */
  readRadiance(): Float32Array {
    const { width, height } = this.#view;
    return this.samples > 0 && this.#accumulation
      ? this.#accumulation.readMean()
      : new Float32Array(4 * width * height);
  }

  /** Frees what it has on the GPU; the canvas keeps its picture. */
  dispose(): void {
    this.#hasScene = false;
    this.#next = undefined;
    this.#device.remove(this.#listener);
    this.#release();
  }

  #show(scene: Scene): void {
    this.#hasScene = true;
    this.#view.scene = scene;
  }

  #isDrawable(): boolean {
    const lost = this.#device.gl.isContextLost();
    return this.#hasScene && !lost && this.#failed !== this.#view.revision && !this.#isQuarantined();
  }

  #advance(budgetMs: number): boolean {
    const prepared = this.#prepare();
    if (!prepared) return false;
    const { tracer, accumulation } = prepared;
    const { samples, seed } = this.#view.settings;
    const { camera } = this.#view.resolved;
    const { width, height } = accumulation;
    const pace = this.#pace;
    const start = performance.now();
    // Issuing work takes no time where the GPU has a queue: there the estimate keeps to the budget, else the clock does.
    const most = pace.msPerSample > 0 ? Math.floor(budgetMs / pace.msPerSample) : 1;
    let added = 0;
    while (accumulation.samples < samples && (added < 1 || (added < most && performance.now() - start < budgetMs))) {
      const jitter = pixelSample(accumulation.samples, seed);
      const sample = { sample: accumulation.samples, seed };
      accumulation.add(() => tracer.draw(cameraFrame(camera, width, height, jitter), sample));
      added++;
    }
    if (added > 0 || !this.#presented) this.#present(accumulation);
    if (added > 0) {
      this.#device.clock.endBatch(this.#listener, start, (ms) => {
        const measured = ms / added;
        pace.msPerSample = pace.msPerSample > 0 ? (pace.msPerSample + measured) / 2 : measured;
      });
    }
    return accumulation.samples < samples;
  }

  #drawAfter(loading: Promise<unknown>): void {
    this.#loading ??= loading
      .finally(() => {
        this.#loading = undefined;
      })
      .then(this.onrestored, (error: Error) => this.#fail(error));
  }

  /** Brings what is on the GPU up to the view; undefined: that waits for parts of the shader. */
  #prepare(): { readonly tracer: Tracer; readonly accumulation: Accumulation } | undefined {
    const { revision, width, height } = this.#view;
    if (this.#tracer && this.#accumulation && this.#drawn === revision) {
      return { tracer: this.#tracer, accumulation: this.#accumulation };
    }
    const { resolved, settings } = this.#view;
    const loading = loadPaths(resolved, settings) ?? loadShaderParts(this.#view.required, this.#device.shaderOptions);
    if (loading) {
      this.#drawAfter(loading);
      return undefined;
    }
    const tracer = this.#tracerFor(this.#view.required);
    tracer.setScene(this.#view.resolved);
    const accumulation = this.#accumulationOf(width, height);
    accumulation.clear();
    this.#drawn = revision;
    return { tracer, accumulation };
  }

  #tracerFor(required: Requirements): Tracer {
    if (this.#tracer?.key === requirementsKey(required)) return this.#tracer;
    const { gl, programs, shaderOptions } = this.#device;
    const start = performance.now();
    const compiledBefore = programs.compileCount;
    const tracer = new Tracer(gl, programs, required, shaderOptions);
    this.#tracer?.dispose();
    this.#tracer = tracer;
    this.#pace = { msPerSample: 0 };
    this.#compiles += programs.compileCount - compiledBefore;
    tracer.compile();
    this.#compileMs += performance.now() - start;
    return tracer;
  }

  #accumulationOf(width: number, height: number): Accumulation {
    if (this.#accumulation?.width === width && this.#accumulation.height === height) return this.#accumulation;
    this.#accumulation?.dispose();
    this.#accumulation = undefined;
    this.#accumulation = new Accumulation(this.#device.gl, this.#device.precision, width, height);
    this.#pace = { msPerSample: 0 };
    return this.#accumulation;
  }

  #present(accumulation: Accumulation): void {
    const { exposure, toneMapping } = this.#view.settings;
    const display = this.#displayFor(toneMapping);
    const { width, height } = accumulation;
    this.#device.present(this.#context, width, height, () => display.draw(accumulation, exposure));
    this.#presented = true;
  }

  #displayFor(toneMapping: RenderSettings['toneMapping']): Display {
    if (this.#display?.toneMapping === toneMapping) return this.#display;
    this.#display?.dispose();
    this.#display = new Display(this.#device.gl, this.#device.programs, toneMapping);
    return this.#display;
  }

  /** Not to be tried again before something changes; and told once, not with every frame of an animation. */
  #fail(error: Error): void {
    this.#failed = this.#view.revision;
    if (error.message === this.#failure) return;
    this.#failure = error.message;
    this.onerror(error);
  }

  #contextLost(suspect: boolean): void {
    this.#tracer = this.#display = this.#accumulation = undefined;
    if (!suspect) return;
    const now = performance.now();
    const again = now - this.#lastLoss < SUSPICION_MS;
    this.#lastLoss = now;
    if (!again) return;
    this.#quarantined = this.#view.key;
    this.onerror(new QuarantineError());
  }

  /** Whether the scene is the one that was sent into quarantine. Another one starts with a clean slate. */
  #isQuarantined(): boolean {
    if (this.#quarantined === undefined) return false;
    if (this.#quarantined === this.#view.key) return true;
    this.#quarantined = undefined;
    this.#lastLoss = Number.NEGATIVE_INFINITY;
    this.#view.forget();
    return false;
  }

  #release(): void {
    this.#tracer?.dispose();
    this.#display?.dispose();
    this.#accumulation?.dispose();
    this.#tracer = this.#display = this.#accumulation = undefined;
  }
}
