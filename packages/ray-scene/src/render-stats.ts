import type { Precision } from './render-device.ts';

/** What a picture is made of so far, and what it cost. */
export interface RenderStats {
  /** Samples that each pixel has, at least. */
  readonly samples: number;
  /**
   * How noisy the picture is, as last measured: the standard error of a channel, relative; the root of the mean of
   * variance / (mean² + 0.01), after exposure. Undefined: not known yet.
   */
  readonly error: number | undefined;
  /** Rays that were sent through pixels, each with all that follows from it. */
  readonly rays: number;
  /** Time spent on the picture so far. */
  readonly seconds: number;
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
