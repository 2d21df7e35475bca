/** What the bench of what governs the samples does in a page: lets the renderer itself go on until it stops. */
import '@ray-scene/core/parts';
// Bundled pages are without it otherwise, and then scenes at true scale are refused before anybody has looked closely.
import '../../packages/core/src/words.ts';
import { parseScene, parseSettings, type RenderSettings } from '@ray-scene/core';
import { AdaptiveOrder } from '../../packages/ray-scene/src/adaptive-order.ts';
import { RenderDevice, Renderer, type RenderStats, type StopReason } from '../../packages/ray-scene/src/renderer.ts';

export interface Task {
  /** JSON text of the scene. */
  readonly scene: string;
  readonly settings: Partial<RenderSettings>;
  readonly width: number;
  readonly height: number;
  /** Whether samples go where the error is, or evenly. */
  readonly adapts: boolean;
}

export interface Stop {
  readonly reason: StopReason;
  readonly stats: RenderStats;
  /** Time that the GPU took, in milliseconds. */
  readonly gpuMs: number;
}

/** Milliseconds of work per draw: there is nobody whose frames it would hold up. */
const BUDGET = 60;

const device = new RenderDevice();
/** Pictures that are added up, and what holds each. */
let sums: Float64Array[] = [];
let squares = new Float64Array();
let renderer: Renderer | undefined;

let gpuMs = 0;
const { endBatch } = device.clock;
device.clock.endBatch = (owner, done) => {
  endBatch.call(device.clock, owner, (ms) => {
    gpuMs += ms;
    done(ms);
  });
};

const nextTask = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve));

const { next } = AdaptiveOrder.prototype;

/** Forgets the pictures so far. */
export function begin(): void {
  renderer?.dispose();
  renderer = undefined;
  sums = [];
  squares = new Float64Array();
}

/** Draws a picture until one of the rules ends it. */
export async function stop({ scene, settings, width, height, adapts }: Task): Promise<Stop> {
  AdaptiveOrder.prototype.next = adapts ? next : () => undefined;
  renderer ??= new Renderer(document.createElement('canvas'), device);
  gpuMs = 0;
  let failure: Error | undefined;
  renderer.onerror = (error) => {
    failure = error;
  };
  renderer.resize(width, height);
  renderer.setSettings(parseSettings(settings));
  renderer.setScene(parseScene(JSON.parse(scene)));
  while (!renderer.stopped) {
    renderer.draw(BUDGET);
    do await nextTask();
    while (device.clock.busyWith);
    if (failure) throw failure;
  }
  return { reason: renderer.stopped, stats: renderer.stats, gpuMs };
}

/** Adds the picture that is there to a sum; pictures of either kind have sums of their own. */
export function keep({ sum, adapts }: { readonly sum: number; readonly adapts: boolean }): void {
  const picture = (renderer as Renderer).readRadiance();
  sums[sum] ??= new Float64Array(picture.length);
  for (const [i, value] of picture.entries()) (sums[sum] as Float64Array)[i] = (sums[sum]?.[i] as number) + value;
  if (squares.length === 0) squares = new Float64Array(2 * picture.length);
  // Of pictures that were made alike: how they differ is their noise.
  const at = adapts ? picture.length : 0;
  for (const [i, value] of picture.entries()) squares[at + i] = (squares[at + i] as number) + value ** 2;
}

export interface Judged {
  /** Of even and of adapted pictures. */
  readonly noise: readonly [number, number];
  readonly squaredBias: number;
  /** Standard error of the squared bias, as the pixels tell it. */
  readonly squaredBiasError: number;
}

/**
 * Noise and bias of pictures, both relative as `stats.error` is. The sums 0 and 1 are of even ones, 2 and 3 of adapted
 * ones, each of `each` pictures.
 */
export function judge(each: number): Judged {
  const all = sums as [Float64Array, Float64Array, Float64Array, Float64Array];
  const [a] = all;
  const count = 2 * each;
  const relative: [number, number] = [0, 0];
  const squaredBiases = new Float64Array(a.length / 4);
  for (let i = 0; i < a.length; i++) {
    if (i % 4 === 3) continue;
    const [one, other, third, fourth] = all.map((sum) => (sum[i] as number) / each) as [number, number, number, number];
    const scale = ((one + other + third + fourth) / 4) ** 2 + 0.01;
    for (const [kind, half] of [(one + other) / 2, (third + fourth) / 2].entries()) {
      const variance = ((squares[kind * a.length + i] as number) / count - half ** 2) * (count / (count - 1));
      relative[kind as 0 | 1] += variance / scale;
    }
    // Each factor has noise of its own, so that the mean of the product has none of it.
    squaredBiases[i >> 2] = (squaredBiases[i >> 2] as number) + ((third - one) * (fourth - other)) / scale / 3;
  }
  const pixels = squaredBiases.length;
  const squaredBias = squaredBiases.reduce((sum, value) => sum + value, 0) / pixels;
  const variance = squaredBiases.reduce((sum, value) => sum + (value - squaredBias) ** 2, 0) / pixels;
  const [even, adapted] = relative.map((sum) => Math.sqrt(sum / 3 / pixels)) as [number, number];
  return { noise: [even, adapted], squaredBias, squaredBiasError: Math.sqrt(variance / pixels) };
}
