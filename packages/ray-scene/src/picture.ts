import type { RenderSettings, ResolvedCamera, Scene } from '@ray-scene/core';
import { Renderer, type RenderStats } from './renderer.ts';

/** All that decides how a picture looks. */
export interface Shown {
  readonly scene: Scene;
  readonly settings: RenderSettings;
  /** Stands in for the scene's camera. */
  readonly camera: ResolvedCamera | undefined;
  readonly size: readonly [width: number, height: number];
}

/** What a turn of drawing has brought. */
export interface Progress {
  readonly samples: number;
  readonly added: boolean;
  /** Whether it wants more samples. */
  readonly more: boolean;
}

/** The picture on a canvas: tells its renderer what has changed, and nothing else. */
export class Picture {
  readonly #renderer: Renderer;
  #shown: Partial<Shown> = {};

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

  get camera(): ResolvedCamera {
    return this.#renderer.camera;
  }

  get stats(): RenderStats {
    return this.#renderer.stats;
  }

  draw(shown: Shown, budgetMs: number): Progress {
    const { scene, settings, camera, size } = shown;
    if (scene !== this.#shown.scene) this.#renderer.setScene(scene);
    if (settings !== this.#shown.settings) this.#renderer.setSettings(settings);
    this.#renderer.setCamera(camera);
    this.#renderer.resize(...size);
    this.#shown = shown;
    const before = this.#renderer.samples;
    const more = this.#renderer.draw(budgetMs);
    const { samples } = this.#renderer;
    return { samples, added: samples !== before, more };
  }

  readRadiance(): Float32Array {
    return this.#renderer.readRadiance();
  }

  dispose(): void {
    this.#renderer.dispose();
  }
}
