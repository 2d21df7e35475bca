/**
 * Keeps up with how noisy a picture is as it goes on, and tells when it is good enough. Loaded when a picture has samples
 * to compare.
 */
import type { RenderSettings } from '@ray-scene/core';
import type { Accumulation } from './accumulation.ts';
import { drawNoiseMap, type NoiseOutput } from './noise-maps.ts';
import { type Noise, NoiseMeter } from './noise-meter.ts';
import type { RenderDevice } from './render-device.ts';
import { type StopReason, stopReason } from './stop-rules.ts';

/** How many times the samples of the last measurement there must be for the next, where something depends on it. */
const CLOSE_STEP = 1.1;
/** The same where nobody looks. */
const WIDE_STEP = 2;

export class NoiseWatch {
  readonly #device: RenderDevice;
  #meter: NoiseMeter | undefined;
  /** A measurement that is on its way; of no other is the result wanted. */
  #awaited: object | undefined;
  #noise: Noise | undefined;

  constructor(device: RenderDevice) {
    this.#device = device;
  }

  /** What was measured last of the present picture. */
  get noise(): Noise | undefined {
    return this.#noise;
  }

  /** Whether a picture that gets no more samples is yet to be measured. */
  isBehind({ samples }: Accumulation, { exposure }: RenderSettings): boolean {
    return this.#noise?.samples !== samples || this.#noise.exposure !== exposure;
  }

  /** Draws what is to be shown instead of the picture. */
  draw(output: NoiseOutput, accumulation: Accumulation): void {
    const meter = this.#noise && this.#meter;
    drawNoiseMap(this.#device, output, { accumulation, meter });
  }

  /** The rule that ends the picture here, if one does. */
  reasonToStop({ samples }: Accumulation, settings: RenderSettings, seconds: number): StopReason | undefined {
    return stopReason(settings, { samples, seconds, noise: this.#noise });
  }

  /**
   * Begins to measure, if it is time for that. Returns what is to be called when the GPU has done it.
   * @param isLast whether the picture gets no more samples.
   */
  begin(accumulation: Accumulation, settings: RenderSettings, isLast: boolean): (() => void) | undefined {
    if (this.#awaited || accumulation.samples < 2 || !this.isBehind(accumulation, settings)) return undefined;
    const matters = settings.maxError !== undefined || settings.output === 'error';
    const step = matters ? CLOSE_STEP : WIDE_STEP;
    if (!isLast && accumulation.samples < step * (this.#noise?.samples ?? 0)) return undefined;
    const collect = this.#meterOf(accumulation).begin(accumulation, settings.exposure);
    this.#awaited = collect;
    return () => {
      if (this.#awaited !== collect) return;
      this.#awaited = undefined;
      this.#noise = collect();
    };
  }

  /** The picture begins anew. */
  restart(): void {
    this.#noise = this.#awaited = undefined;
  }

  release(): void {
    this.#meter?.dispose();
    this.forget();
  }

  /** What it had on the GPU went with the context. */
  forget(): void {
    this.#meter = undefined;
    this.restart();
  }

  #meterOf(accumulation: Accumulation): NoiseMeter {
    const { width, height } = accumulation;
    if (this.#meter?.width === width && this.#meter.height === height) return this.#meter;
    this.release();
    const { gl, programs, precision } = this.#device;
    this.#meter = new NoiseMeter(gl, programs, precision, accumulation);
    return this.#meter;
  }
}
