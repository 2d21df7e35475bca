/**
 * Keeps up with how noisy a picture is as it goes on, and tells when it is good enough. Loaded when a picture has samples
 * to compare.
 */
import type { RenderSettings } from '@ray-scene/core';
import type { Accumulation } from './accumulation.ts';
import { AdaptiveOrder } from './adaptive-order.ts';
import { gpuTimer } from './gpu-timer.ts';
import { drawNoiseMap, type NoiseOutput } from './noise-maps.ts';
import { type Noise, NoiseMeter } from './noise-meter.ts';
import type { RenderDevice } from './render-device.ts';
import { FEWEST_SAMPLES, type StopReason, stopReason } from './stop-rules.ts';

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
  /** By what was measured last. */
  #order: AdaptiveOrder | undefined;

  constructor(device: RenderDevice) {
    this.#device = device;
    this.#useTimer();
  }

  /** What was measured last of the present picture. */
  get noise(): Noise | undefined {
    return this.#noise;
  }

  /** Whether a picture that gets no more samples is yet to be measured. */
  isBehind({ cells }: Accumulation, { exposure }: RenderSettings): boolean {
    return this.#noise?.rays !== cells.rays || this.#noise.exposure !== exposure;
  }

  /**
   * Where the next samples are to go, if not evenly: work goes where the error is as soon as that is known, and only
   * where an error is asked for. Who asks for so many samples per pixel gets them.
   */
  order({ maxError }: RenderSettings): AdaptiveOrder | undefined {
    const noise = this.#noise;
    if (maxError === undefined || !noise || noise.samples < FEWEST_SAMPLES) return undefined;
    this.#order ??= new AdaptiveOrder(noise);
    return this.#order;
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
    if (!isLast && accumulation.cells.rays < step * (this.#noise?.rays ?? 0)) return undefined;
    this.#device.clock.beginBatch();
    const collect = this.#meterOf(accumulation).begin(accumulation, settings.exposure);
    this.#awaited = collect;
    return () => {
      if (this.#awaited !== collect) return;
      this.#awaited = undefined;
      this.#noise = collect();
      this.#order = undefined;
    };
  }

  /** The picture begins anew. */
  restart(): void {
    this.#noise = this.#awaited = this.#order = undefined;
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
    this.#useTimer();
    return this.#meter;
  }

  /** Anew after a loss of the context. */
  #useTimer(): void {
    const { clock, gl } = this.#device;
    clock.timer ??= gpuTimer(gl);
  }
}
