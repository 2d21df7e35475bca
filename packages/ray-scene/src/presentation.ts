import { isSurfaceOutput, type RenderSettings } from '@ray-scene/core';
import type { Accumulation } from './accumulation.ts';
import { Display } from './display.ts';
import type { NoiseWatch } from './noise-watch.ts';
import type { RenderDevice } from './render-device.ts';
import type { View } from './view.ts';

/** Brings the pictures of a view to its canvas, and remembers what the canvas shows. */
export class Presentation {
  /** Which revision of the view is shown. */
  revision = -1;
  /** How many rays the picture is made of that is shown. */
  rays = 0;
  readonly #device: RenderDevice;
  readonly #context: CanvasRenderingContext2D;
  readonly #view: View;
  #display: Display | undefined;

  constructor(device: RenderDevice, context: CanvasRenderingContext2D, view: View) {
    this.#device = device;
    this.#context = context;
    this.#view = view;
  }

  /** @param watch draws the outputs that tell of noise; without one they are not shown yet. */
  show(picture: Accumulation, watch: NoiseWatch | null | undefined): void {
    this.revision = this.#view.revision;
    const { exposure, toneMapping, output } = this.#view.settings;
    const { width, height } = picture;
    // What surfaces are like is no light.
    const isLight = !isSurfaceOutput(output);
    let draw = (): void => this.#displayFor(isLight ? toneMapping : 'none').draw(picture, isLight ? exposure : 1);
    if (output === 'error' || output === 'samples') {
      if (!watch) return;
      draw = () => watch.draw(output, picture);
    }
    this.#device.present(this.#context, width, height, draw);
    this.rays = picture.cells.rays;
  }

  /** After a loss of the context: there is nothing to free. */
  forget(): void {
    this.#display = undefined;
  }

  release(): void {
    this.#display?.dispose();
    this.#display = undefined;
  }

  #displayFor(toneMapping: RenderSettings['toneMapping']): Display {
    if (this.#display?.toneMapping === toneMapping) return this.#display;
    this.release();
    this.#display = new Display(this.#device.gl, this.#device.programs, toneMapping);
    return this.#display;
  }
}
