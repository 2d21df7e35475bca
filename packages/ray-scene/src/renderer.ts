/** `ray-scene/renderer`: draws scenes on canvases, without any element. */
import {
  type EnvironmentImages,
  loadShapes,
  type RenderSettings,
  type ResolvedCamera,
  type Scene,
} from '@ray-scene/core';
import type { Accumulation } from './accumulation.ts';
import type { NoiseWatch } from './noise-watch.ts';
import { Presentation } from './presentation.ts';
import type { Quarantine } from './quarantine.ts';
import { type DeviceView, RenderDevice } from './render-device.ts';
import type { RenderStats } from './render-stats.ts';
import { type Preview, Sampling } from './sampling.ts';
import type { StopReason } from './stop-rules.ts';
import { View } from './view.ts';

export { ShaderError } from './program.ts';
export { QuarantineError } from './quarantine.ts';
export { type Precision, RenderDevice, type RenderDeviceOptions, WebGLUnavailableError } from './render-device.ts';
export type { RenderStats } from './render-stats.ts';
export type { StopReason } from './stop-rules.ts';

/** By how much rays must have become more for a picture to be shown anew: showing it takes time as well. */
const VISIBLE = 1.05;

/** Of the time between two draws no more counts as time spent on a picture: nobody asked for one meanwhile. */
const LONGEST_PAUSE_MS = 1000;

/** A view of a scene. Everything on the GPU is made when it is first needed, and again after a loss of the context. */
export class Renderer {
  /** Told of what goes wrong while drawing; by default it becomes an uncaught error of the page. */
  onerror: (error: Error) => void = (error) => reportError(error);
  /** Told when the picture should be drawn again: a lost context is back, or what the scene waited for is there. */
  onrestored: () => void = () => {};

  readonly #device: RenderDevice;
  readonly #view = new View();
  readonly #sampling: Sampling;
  readonly #presentation: Presentation;
  readonly #listener: DeviceView = {
    contextLost: (suspect) => this.#contextLost(suspect),
    contextRestored: () => this.onrestored(),
  };
  /** Null: not to be had. */
  #watch: NoiseWatch | null | undefined;
  #loadingWatch: Promise<void> | undefined;
  /** Made when the context was lost once while the GPU was at this scene. */
  #quarantine: Quarantine | undefined;
  #hasScene = false;
  /** What was asked for last. */
  #next: Scene | undefined;
  /** The parts of its shader that the scene waits for. */
  #loading: Promise<unknown> | undefined;
  /** Which revision of the view the time, the end and the picture are of. */
  #begun = -1;
  #stopped: StopReason | undefined;
  #milliseconds = 0;
  #lastDraw = Number.NEGATIVE_INFINITY;
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
    this.#device = device;
    this.#sampling = new Sampling(device, this.#view);
    this.#presentation = new Presentation(device, context, this.#view);
    device.add(this.#listener);
  }

  /**
   * The scene to draw; one with shapes that the page has not loaded yet takes its place when they are there.
   * @param images of its surroundings.
   */
  setScene(scene: Scene, images?: EnvironmentImages): void {
    this.#next = scene;
    const loading = loadShapes(scene);
    if (!loading) this.#show(scene, images);
    loading?.then(
      () => {
        if (this.#next !== scene) return;
        this.#show(scene, images);
        this.onrestored();
      },
      (error: Error) => this.onerror(error),
    );
  }

  setSettings(settings: RenderSettings): void {
    this.#view.settings = settings;
    this.#presentation.rays = 0;
    this.#stopped = undefined;
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
   * Adds samples to the picture for about as long as the budget lasts, at least some pixels' unless it is complete, and
   * shows it. Nothing is added as long as the driver compiles, nor, without any budget, to a picture of all pixels.
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

  /** Whether the canvas shows the view as it is now, be it by a preview. */
  get isShown(): boolean {
    return this.#presentation.revision === this.#view.revision;
  }

  /**
   * Whether the GPU is so far behind that more work would only make it later. That it is not any more
   * is known in a later task only.
   */
  get isBehind(): boolean {
    return this.#device.clock.batchesOf(this.#listener) > (this.#sampling.pace.isKnown ? 1 : 0);
  }

  /** Samples that each pixel of the present scene has. */
  get samples(): number {
    return this.#sampling.accumulation?.samples ?? 0;
  }

  /** The rule that has ended the picture. */
  get stopped(): StopReason | undefined {
    return this.#begun === this.#view.revision ? this.#stopped : undefined;
  }

  /** Whether it will soon be known how noisy a complete picture is. Further calls of `draw` see to it. */
  get isMeasuring(): boolean {
    const { accumulation } = this.#sampling;
    if (!accumulation || accumulation.samples < 2 || !this.stopped || this.#watch === null) return false;
    return this.stopped !== 'error' && this.#watch?.isBehind(accumulation, this.#view.settings) !== false;
  }

  get stats(): RenderStats {
    const { accumulation, compiles, compileMs, pace } = this.#sampling;
    const { width, height } = this.#view;
    return {
      samples: this.samples,
      error: accumulation && this.#watch?.noise?.error,
      rays: accumulation?.cells.rays ?? 0,
      seconds: accumulation ? this.#milliseconds / 1000 : 0,
      compiles,
      compileMs,
      msPerSample: pace.msFor(width * height),
      width,
      height,
      precision: this.#device.precision,
    };
  }

  /** The mean of the samples: linear radiance RGBA premultiplied, the top row first. Zeros before the first draw. */
  readRadiance(): Float32Array {
    const { width, height } = this.#view;
    return this.#sampling.accumulation?.readMean() ?? new Float32Array(4 * width * height);
  }

  /** Frees what it has on the GPU; the canvas keeps its picture. */
  dispose(): void {
    this.#hasScene = false;
    this.#next = undefined;
    this.#device.remove(this.#listener);
    this.#release();
  }

  #show(scene: Scene, images: EnvironmentImages | undefined): void {
    this.#hasScene = true;
    this.#view.setScene(scene, images);
  }

  #isDrawable(): boolean {
    const lost = this.#device.gl.isContextLost();
    return this.#hasScene && !lost && this.#failed !== this.#view.revision && !this.#isQuarantined();
  }

  #advance(budgetMs: number): boolean {
    const start = performance.now();
    const loading = this.#sampling.loadParts();
    if (loading) {
      this.#drawAfter(loading);
      return false;
    }
    const accumulation = this.#sampling.prepare();
    // The last good picture stays until there is a program for another.
    if (!accumulation) return true;
    const { settings } = this.#view;
    const isNew = this.#begin(start);
    const preview = settings.output === 'beauty' && this.#sampling.preview(isNew, budgetMs || settings.frameBudget);
    if (preview) {
      this.#showPreview(start, preview);
      return true;
    }
    this.#stopped ??= this.#reasonToStop(accumulation);
    const adds = !this.#stopped && (budgetMs > 0 || accumulation.samples === 0);
    const order = this.#watch?.order(settings);
    const pixels = adds ? this.#sampling.add(budgetMs || settings.frameBudget, settings.samples, order) : 0;
    this.#spend(start);
    this.#stopped ??= this.#reasonToStop(accumulation);
    if (accumulation.samples > 1 || settings.maxTime || settings.output !== 'beauty') this.#loadWatch();
    const collect = this.#watch?.begin(accumulation, settings, this.#stopped !== undefined);
    if (pixels > 0 || collect) {
      const { pace } = this.#sampling;
      this.#device.clock.endBatch(this.#listener, (ms) => {
        if (pixels > 0) pace.learn(ms, pixels);
        collect?.();
        if (collect && settings.output === 'error') this.#presentation.rays = 0;
      });
    }
    const enough = this.#presentation.rays * (this.#stopped ? 1 : VISIBLE);
    if (accumulation.samples > 0 && accumulation.cells.rays > enough)
      this.#presentation.show(accumulation, this.#watch);
    return !this.#stopped;
  }

  #drawAfter(loading: Promise<unknown>): void {
    this.#loading ??= loading
      .finally(() => {
        this.#loading = undefined;
      })
      .then(this.onrestored, (error: Error) => this.#fail(error));
  }

  #showPreview(start: number, { picture, pixels }: Preview): void {
    const { pace } = this.#sampling;
    this.#device.clock.endBatch(this.#listener, (ms) => pace.learn(ms, pixels));
    this.#spend(start);
    if (picture.samples > 0) this.#presentation.show(picture, this.#watch);
    this.#loadWatch();
  }

  /** A new picture, if the view is another one: returns whether it is. */
  #begin(now: number): boolean {
    const { revision } = this.#view;
    if (this.#begun === revision) return false;
    this.#begun = revision;
    this.#stopped = undefined;
    this.#presentation.rays = this.#milliseconds = 0;
    this.#lastDraw = now;
    this.#watch?.restart();
    return true;
  }

  /** Counts the time since the last draw, and that of this one. */
  #spend(start: number): void {
    const now = performance.now();
    this.#milliseconds += Math.min(start - this.#lastDraw, LONGEST_PAUSE_MS) + now - start;
    this.#lastDraw = now;
  }

  #reasonToStop(accumulation: Accumulation): StopReason | undefined {
    const { settings } = this.#view;
    if (accumulation.samples >= settings.samples) return 'samples';
    return this.#watch?.reasonToStop(accumulation, settings, this.#milliseconds / 1000);
  }

  #loadWatch(): void {
    this.#loadingWatch ??= import('./noise-watch.ts').then(
      ({ NoiseWatch }) => {
        this.#watch = new NoiseWatch(this.#device);
      },
      (error: Error) => {
        // Without it samples are still a rule.
        this.#watch = null;
        reportError(error);
      },
    );
  }

  /** Not to be tried again before something changes; and told once, not with every frame of an animation. */
  #fail(error: Error): void {
    this.#failed = this.#view.revision;
    if (error.message === this.#failure) return;
    this.#failure = error.message;
    this.onerror(error);
  }

  #contextLost(suspect: boolean): void {
    this.#sampling.forget();
    this.#watch?.forget();
    this.#presentation.forget();
    this.#begun = -1;
    if (suspect) this.#suspect(performance.now()).catch(reportError);
  }

  async #suspect(now: number): Promise<void> {
    const { Quarantine, QuarantineError } = await import('./quarantine.ts');
    this.#quarantine ??= new Quarantine();
    if (this.#quarantine.suspect(this.#view.key, now)) this.onerror(new QuarantineError());
  }

  #isQuarantined(): boolean {
    if (!this.#quarantine?.isOn) return false;
    if (!this.#quarantine.lets(this.#view.key)) return true;
    this.#view.forget();
    return false;
  }

  #release(): void {
    this.#sampling.release();
    this.#watch?.release();
    this.#presentation.release();
  }
}
