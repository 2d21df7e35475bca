/**
 * What the measurement of the trade does in a page: draws a scene with all its settings, many times with other random
 * numbers, and keeps the pictures here: only numbers leave.
 */
import { RenderDevice } from '../../../packages/ray-scene/src/render-device.ts';
import { meanFlip } from './flip.ts';
import { CONVERGED, type Setting } from './knobs.ts';
import { HEIGHT, Picture, WIDTH } from './picture.ts';
import {
  type Bias,
  biasOf,
  type Converged,
  type Noise,
  noiseOf,
  psnr,
  type Radiance,
  Spread,
  shown,
} from './statistics.ts';

const devices: { [T in Setting['target']]?: RenderDevice } = {};

function deviceOf(target: Setting['target']): RenderDevice {
  devices[target] ??= new RenderDevice({ precision: target });
  return devices[target];
}

let scene = '';
let converged: Converged = { mean: new Float32Array(), variance: new Float64Array() };
let picture: Picture | undefined;

/** Runs that a converged picture is the mean of; their spread tells how well it is known. */
const RUNS = 8;
/** Samples that each of them gets in turn. */
const TURN = 16;
/** So that no other picture has their random numbers. */
const FIRST_SEED = 1000;

/** Draws the picture that all settings of a scene are held to, for so long. Returns how many samples each pixel got. */
export function converge(task: { readonly scene: string; readonly milliseconds: number }): {
  readonly samples: number;
  readonly noise: number;
} {
  scene = task.scene;
  const end = performance.now() + task.milliseconds;
  const runs = Array.from({ length: RUNS }, () => new Picture(deviceOf('float'), scene, CONVERGED));
  let samples = 0;
  do {
    samples += TURN;
    for (const [run, one] of runs.entries()) one.drawTo(samples, FIRST_SEED + run);
    runs.at(-1)?.wait();
  } while (performance.now() < end);
  const spread = new Spread(3 * WIDTH * HEIGHT);
  for (const run of runs) {
    spread.add(run.read());
    run.dispose();
  }
  converged = spread.converged();
  return { samples: RUNS * samples, noise: noiseOf(spread, converged).noise / Math.sqrt(RUNS) };
}

/** From the parsed scene to the first pixel that can be read, in a context that is there. */
export function open(setting: Setting): {
  readonly compileMs: number;
  readonly firstFrameMs: number;
  readonly shaderChars: number;
} {
  picture?.dispose();
  const device = deviceOf(setting.target);
  const start = performance.now();
  picture = new Picture(device, scene, setting);
  const compiled = performance.now();
  picture.drawTo(1, 0);
  picture.wait();
  const { shaderChars } = picture;
  return { compileMs: compiled - start, firstFrameMs: performance.now() - start, shaderChars };
}

/** Draws so many frames, each of one sample more and shown, and waits for them; returns how many milliseconds passed. */
export function runFrames(frames: number): number {
  const start = performance.now();
  picture?.clear();
  for (let frame = 1; frame <= frames; frame++) {
    picture?.drawTo(frame, 0);
    picture?.show();
  }
  picture?.wait();
  return performance.now() - start;
}

/** Draws so many samples and waits for them; returns how many milliseconds passed. */
export function run(samples: number): number {
  const start = performance.now();
  picture?.clear();
  picture?.drawTo(samples, 0);
  picture?.wait();
  return performance.now() - start;
}

/** What is known of a setting with so many samples. */
export interface Point extends Noise {
  readonly samples: number;
  /** Of the first seed, to the converged picture. */
  readonly psnr: number;
  readonly flip: number;
}

export interface Accuracy extends Bias {
  readonly seeds: number;
  readonly points: readonly Point[];
}

export interface Task {
  readonly samples: readonly number[];
  /** At least, and at most as long as there is time for more. */
  readonly leastSeeds: number;
  readonly mostSeeds: number;
  readonly milliseconds: number;
}

/** Draws the setting that is open again and again, with other random numbers each time. */
export function measure({ samples, leastSeeds, mostSeeds, milliseconds }: Task): Accuracy {
  const end = performance.now() + milliseconds;
  const one = picture as Picture;
  const gathered = samples.map((count) => ({
    count,
    spread: new Spread(converged.mean.length),
    first: undefined as Radiance | undefined,
  }));
  let seeds = 0;
  while (seeds < leastSeeds || (seeds < mostSeeds && performance.now() < end)) {
    one.clear();
    for (const stage of gathered) {
      one.drawTo(stage.count, seeds);
      const radiance = one.read();
      stage.first ??= radiance;
      stage.spread.add(radiance);
    }
    seeds++;
  }
  const right = Array.from(converged.mean, shown);
  const points = gathered.map(({ count, spread, first = new Float32Array() }) => {
    const data = Array.from(first, shown);
    return {
      samples: count,
      ...noiseOf(spread, converged),
      psnr: psnr(data, right),
      flip: meanFlip({ width: WIDTH, height: HEIGHT, data }, { width: WIDTH, height: HEIGHT, data: right }),
    };
  });
  return { seeds, points, ...biasOf((gathered.at(-1) as (typeof gathered)[number]).spread, converged) };
}
