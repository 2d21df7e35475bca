import type { EnvironmentImages, RenderSettings, ResolvedCamera, Scene } from '@ray-scene/core';
import { Renderer, type RenderStats, type StopReason } from './renderer.ts';

/** What a turn of drawing has brought. */
export interface Progress {
  /** Per pixel, in the mean: where work goes where the error is, some get more for a long time. */
  readonly samples: number;
  readonly added: boolean;
  /** Whether the picture is of the scene as it is now, be it by a preview. */
  readonly shown: boolean;
  /** Whether it wants another turn: more samples, or a last look at how noisy they are. */
  readonly more: boolean;
  /** What has ended the picture. */
  readonly stopped: StopReason | undefined;
  /** How noisy it is, as far as is known. */
  readonly error: number | undefined;
}

/** The picture on a canvas: tells its renderer what has changed, and nothing else. */
export class Picture {
  readonly #renderer: Renderer;
  #scene: Scene | undefined;
  #settings: RenderSettings | undefined;

  private constructor(renderer: Renderer) {
    this.#renderer = renderer;
  }

  /** Returns nothing where there is no WebGL, which is told as every failure is. */
  static open(canvas: HTMLCanvasElement, onerror: (error: Error) => void, onrestored: () => void): Picture | undefined {
    try {
      return new Picture(Object.assign(new Renderer(canvas), { onerror, onrestored }));
    } catch (error) {
      onerror(error as Error);
      return undefined;
    }
  }

  /** The camera in use, once there is a scene. */
  get camera(): ResolvedCamera | undefined {
    return this.#scene && this.#renderer.camera;
  }

  get stats(): RenderStats {
    return this.#renderer.stats;
  }

  show(
    scene: Scene,
    images: EnvironmentImages | undefined,
    settings: RenderSettings,
    [width, height]: readonly [number, number],
  ): void {
    if (scene !== this.#scene) this.#renderer.setScene(scene, images);
    if (settings !== this.#settings) this.#renderer.setSettings(settings);
    this.#renderer.resize(width, height);
    this.#scene = scene;
    this.#settings = settings;
  }

  /** @param camera stands in for the scene's. */
  draw(camera: ResolvedCamera | undefined, budgetMs: number): Progress {
    this.#renderer.setCamera(camera);
    const before = this.#samples;
    const waits = budgetMs > 0 && this.#renderer.isBehind;
    const more = waits || this.#renderer.draw(budgetMs) || this.#renderer.isMeasuring;
    const samples = this.#samples;
    const { isShown: shown, stopped, stats } = this.#renderer;
    return { samples, added: samples !== before, shown, more, stopped, error: stats.error };
  }

  get #samples(): number {
    const { rays, width, height } = this.stats;
    return Math.floor(rays / (width * height));
  }

  readRadiance(): Float32Array {
    return this.#renderer.readRadiance();
  }

  dispose(): void {
    this.#renderer.dispose();
  }
}
