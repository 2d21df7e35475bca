/** The samples of a view on the GPU: what they are traced with, what they are gathered in, and how fast they come. */
import { cameraFrame, loadPaths, loadShaderParts, requirementsKey } from '@ray-scene/core';
import { Accumulation } from './accumulation.ts';
import type { AdaptiveOrder } from './adaptive-order.ts';
import { CELL_PIXELS, type Tile } from './cells.ts';
import { Pace } from './pace.ts';
import type { RenderDevice } from './render-device.ts';
import type { SceneTextures } from './scene-textures.ts';
import { Tracer } from './tracer.ts';
import type { View } from './view.ts';

/** With fewer pixels nothing can be recognised: where even they take longer than a budget, so be it. */
const FEWEST_PIXELS = 2 ** 10;
/** How often the pixels of a preview are doubled for the next: all of them together take a third of a sample. */
const FINER = 2;
/** How much faster samples must come, as a power of two, than previews of the next size take to be made. */
const SLACK = 0.25;

/** A smaller picture, and how many pixels were drawn just now. It is to be shown when it is whole. */
export interface Preview {
  readonly picture: Accumulation;
  readonly pixels: number;
}

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
  /** How often the pixels of the preview are halved, and those of the first one of a view. */
  #halvings = 0;
  #coarsest = 0;
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
   * Draws at a smaller picture of the view: first one of as many pixels as the budget has time for, at once, then finer
   * ones; undefined: it is time for the picture itself. To be called when prepared.
   * @param isNew whether the view has changed.
   */
  preview(isNew: boolean, budgetMs: number): Preview | undefined {
    const isNext = isNew || this.#preview?.samples;
    if (isNew) this.#halvings = this.#coarsest = this.#coarse(budgetMs);
    else if (isNext) this.#halvings = Math.max(0, this.#halvings - FINER);
    if (this.#halvings === 0) return undefined;
    if (isNext) {
      const { width, height } = this.#view;
      const shorter = (length: number) => Math.max(1, Math.round(length * 2 ** (-this.#halvings / 2)));
      this.#preview = this.#fitted(this.#preview, shorter(width), shorter(height));
      this.#preview.clear();
    }
    const picture = this.#preview as Accumulation;
    return { picture, pixels: this.#fill(picture, isNew ? Infinity : budgetMs, 1) };
  }

  /**
   * Adds samples for about as long as the budget lasts, at least one tile. To be called when prepared. Returns how many
   * pixels it took.
   * @param most samples that a pixel is to have.
   * @param order where they are to go, if not evenly.
   */
  add(budgetMs: number, most: number, order?: AdaptiveOrder): number {
    return this.#fill(this.#accumulation as Accumulation, budgetMs, most, order);
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

  /** How often the pixels are to be halved for a picture that can be drawn at once. */
  #coarse(budgetMs: number): number {
    const { width, height } = this.#view;
    const budgets = (width * height) / Math.max(FEWEST_PIXELS, this.pace.pixelsIn(budgetMs));
    const halvings = Math.log2(budgets);
    // In steps that a pace which wavers does not cross again and again.
    const spare = this.#coarsest - halvings;
    return spare < 0 || spare > 1 + SLACK ? Math.max(0, Math.ceil(halvings)) : this.#coarsest;
  }

  #fill(accumulation: Accumulation, budgetMs: number, most: number, order?: AdaptiveOrder): number {
    this.#device.clock.beginBatch();
    const start = performance.now();
    // Issuing work takes no time where the GPU has a queue: there the estimate keeps to the budget, else the clock does.
    const room = this.pace.pixelsIn(budgetMs);
    let pixels = 0;
    const hasTime = (): boolean =>
      this.pace.isKnown && pixels + CELL_PIXELS <= room && performance.now() - start < budgetMs;
    do pixels += this.#addTiles(accumulation, room - pixels, most, order);
    while (accumulation.samples < most && hasTime());
    return pixels;
  }

  #addTiles(accumulation: Accumulation, room: number, most: number, order: AdaptiveOrder | undefined): number {
    const { camera } = this.#view.resolved;
    const { width, height, cells } = accumulation;
    const { rays } = cells;
    const fitting = room < width * height ? Math.max(1, Math.floor(room / CELL_PIXELS)) : Infinity;
    const tiles = order?.next(cells, fitting, most) ?? [cells.next(fitting)];
    // A function of the sample alone, so that tiles make no difference.
    const { seed, clamp } = this.#view.settings;
    const sample = cells.countOf(tiles[0] as Tile);
    const tracer = this.#tracer as Tracer;
    tracer.use(cameraFrame(camera, width, height), { sample, seed, clamp });
    accumulation.add(() => tracer.drawPixels(), tiles);
    return cells.rays - rays;
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
