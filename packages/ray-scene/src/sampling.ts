/** The samples of a view on the GPU: what they are traced with, what they are gathered in, and how fast they come. */
import { cameraFrame, loadPaths, loadShaderParts, pixelSample, requirementsKey } from '@ray-scene/core';
import { Accumulation } from './accumulation.ts';
import { CELL_PIXELS } from './cells.ts';
import { Pace } from './pace.ts';
import type { RenderDevice } from './render-device.ts';
import type { SceneTextures } from './scene-textures.ts';
import { Tracer } from './tracer.ts';
import type { View } from './view.ts';

/** How many budgets a first sample of all pixels may take. One that takes more is drawn in tiles, after a preview. */
const AT_ONCE = 1.5;
/** How far the pace may move, as a power of two, before previews of another size are made. */
const SLACK = 0.25;

export class Sampling {
  /** Replaced when another program makes earlier measurements worthless. */
  pace = new Pace();
  /** Programs that were compiled, and how long it was waited for them. */
  compiles = 0;
  compileMs = 0;
  readonly #device: RenderDevice;
  readonly #view: View;
  #tracer: Tracer | undefined;
  #accumulation: Accumulation | undefined;
  #preview: Accumulation | undefined;
  /** How often the pixels of a preview are halved. */
  #halvings = 0;
  /** What puts images on the GPU, once a scene has one. */
  #Textures: typeof SceneTextures | undefined;
  /** Which revision of the view the samples are of. */
  #drawn = -1;
  /** When the present program began to be compiled, as long as nobody knows that it is. */
  #compilingSince: number | undefined;

  constructor(device: RenderDevice, view: View) {
    this.#device = device;
    this.#view = view;
  }

  /** What has been gathered, if it is of the view as it is now. */
  get accumulation(): Accumulation | undefined {
    return this.#drawn === this.#view.revision ? this.#accumulation : undefined;
  }

  /** Loads what the shader of the view is made of; undefined: it is all there. */
  loadParts(): Promise<unknown> | undefined {
    if (this.accumulation) return undefined;
    const { resolved, settings } = this.#view;
    return (
      loadPaths(resolved, settings) ??
      loadShaderParts(this.#view.required, this.#device.shaderOptions) ??
      (resolved.images && !this.#Textures ? this.#loadTextures() : undefined)
    );
  }

  /**
   * Brings what is on the GPU up to the view. Returns nothing as long as the driver is at the program.
   * @throws {Error} when the scene cannot be drawn.
   */
  prepare(): Accumulation | undefined {
    if (this.accumulation) return this.accumulation;
    const tracer = this.#tracerOfView();
    if (!tracer.isReady) return undefined;
    tracer.compile();
    if (this.#compilingSince !== undefined) this.compileMs += performance.now() - this.#compilingSince;
    this.#compilingSince = undefined;
    tracer.setScene(this.#view.resolved, this.#Textures);
    const { width, height, revision } = this.#view;
    this.#accumulation = this.#fitted(this.#accumulation, width, height);
    this.#accumulation.clear();
    this.#drawn = revision;
    return this.#accumulation;
  }

  /**
   * Draws a smaller picture of the view, of as many pixels as the budget has time for; undefined: a whole one can be drawn
   * at once, or nobody knows yet. To be called when prepared.
   */
  preview(budgetMs: number): Accumulation | undefined {
    const { width, height } = this.#view;
    const budgets = this.pace.msFor(width * height) / budgetMs;
    if (budgets <= AT_ONCE) return undefined;
    // In steps that a pace which wavers does not cross again and again.
    const halvings = Math.log2(budgets);
    const spare = this.#halvings - halvings;
    if (spare < -SLACK || spare > 1 + SLACK) this.#halvings = Math.ceil(halvings);
    const [w, h] = [width, height].map((length) => Math.max(1, Math.round(length * 2 ** (-this.#halvings / 2))));
    this.#preview = this.#fitted(this.#preview, w as number, h as number);
    this.#preview.clear();
    this.#addTile(this.#preview, width * height);
    return this.#preview;
  }

  /**
   * Adds samples for about as long as the budget lasts, at least one tile. To be called when prepared. Returns how many
   * pixels it took.
   * @param most samples that a pixel is to have.
   */
  add(budgetMs: number, most: number): number {
    const accumulation = this.#accumulation as Accumulation;
    const start = performance.now();
    // Issuing work takes no time where the GPU has a queue: there the estimate keeps to the budget, else the clock does.
    const { width, height, cells } = accumulation;
    const isShort = cells.rays === 0 && this.pace.msFor(width * height) <= AT_ONCE * budgetMs;
    const room = this.pace.pixelsIn(isShort ? AT_ONCE * budgetMs : budgetMs);
    let pixels = 0;
    const hasTime = (): boolean =>
      this.pace.isKnown && pixels + CELL_PIXELS <= room && performance.now() - start < budgetMs;
    do pixels += this.#addTile(accumulation, room - pixels);
    while (accumulation.samples < most && hasTime());
    return pixels;
  }

  /** Frees what it has on the GPU. */
  release(): void {
    this.#tracer?.dispose();
    this.#accumulation?.dispose();
    this.#preview?.dispose();
    this.forget();
  }

  /** What it had on the GPU went with the context. */
  forget(): void {
    this.#tracer = this.#accumulation = this.#preview = undefined;
    this.#drawn = -1;
  }

  async #loadTextures(): Promise<void> {
    this.#Textures = (await import('./scene-textures.ts')).SceneTextures;
  }

  #addTile(accumulation: Accumulation, room: number): number {
    const { camera } = this.#view.resolved;
    const { width, height, cells } = accumulation;
    const tile = room < width * height ? cells.next(Math.max(1, Math.floor(room / CELL_PIXELS))) : cells.next(Infinity);
    // A function of the sample alone, so that tiles make no difference.
    const { seed, clamp } = this.#view.settings;
    const sample = cells.countOf(tile);
    const frame = cameraFrame(camera, width, height, pixelSample(sample, seed));
    accumulation.add(() => this.#tracer?.draw(frame, { sample, seed, clamp }), tile);
    return cells.pixelsOf(tile);
  }

  #tracerOfView(): Tracer {
    const { required } = this.#view;
    if (this.#tracer?.key === requirementsKey(required)) return this.#tracer;
    const { gl, programs, shaderOptions } = this.#device;
    const start = performance.now();
    const compiledBefore = programs.compileCount;
    const tracer = new Tracer(gl, programs, required, shaderOptions);
    this.#tracer?.dispose();
    this.#tracer = tracer;
    this.pace = new Pace();
    this.compiles += programs.compileCount - compiledBefore;
    this.#compilingSince = start;
    return tracer;
  }

  /** The targets that are there, if they have this size, else others. */
  #fitted(present: Accumulation | undefined, width: number, height: number): Accumulation {
    if (present?.width === width && present.height === height) return present;
    present?.dispose();
    return new Accumulation(this.#device.gl, this.#device.precision, width, height);
  }
}
