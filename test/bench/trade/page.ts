/**
 * What the measurement of the trade does in a page: draws a scene with all its settings, many times with other random
 * numbers, and keeps the pictures here: only numbers leave.
 */
import '@ray-scene/core/parts';
import {
  cameraFrame,
  generateShader,
  parseScene,
  pixelSample,
  type ResolvedScene,
  requirements,
  resolveScene,
} from '@ray-scene/core';
import { type PathParts, pathParts, registerPaths } from '../../../packages/core/src/parts.ts';
import { Accumulation } from '../../../packages/ray-scene/src/accumulation.ts';
import { NoiseMeter } from '../../../packages/ray-scene/src/noise-meter.ts';
import { ProgramCache } from '../../../packages/ray-scene/src/program-cache.ts';
import { RenderDevice } from '../../../packages/ray-scene/src/render-device.ts';
import { Tracer } from '../../../packages/ray-scene/src/tracer.ts';
import { meanFlip } from './flip.ts';
import { CONVERGED, type Setting } from './knobs.ts';
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

/** In pixels: whole cells. */
const WIDTH = 96;
const HEIGHT = 64;

const WHOLE_PATHS = pathParts();

/** Paths with the roulette and the choice of lights of a setting, which the product does not let anyone choose. */
const pathsOf = ({ roulette, lights }: Setting): PathParts => ({
  ...WHOLE_PATHS,
  limitsGlsl: (required) =>
    WHOLE_PATHS.limitsGlsl(required).replace(/ROULETTE_FROM = \d+/, `ROULETTE_FROM = ${roulette}`),
  packEmitters(scene, frame, numbers, required) {
    const packed = WHOLE_PATHS.packEmitters(scene, frame, numbers, required);
    if (lights === 'power') return packed;
    // The places that no emitter fills come last.
    const { count: filled } = packed.choice as { readonly count: number };
    const emitters = packed.emitters.map(({ object, record }, alias) =>
      alias < filled
        ? { object, record: { ...record, probability: 1 / filled, threshold: 1, alias } }
        : { object, record },
    );
    return { ...packed, emitters };
  },
});

/** A scene on the GPU, as one setting draws it. */
class Picture {
  readonly shaderChars: number;
  readonly #device: RenderDevice;
  readonly #programs: ProgramCache;
  readonly #scene: ResolvedScene;
  readonly #tracer: Tracer;
  readonly #target: Accumulation;
  readonly #meter: NoiseMeter;
  readonly #pixel = new Float32Array(4);

  constructor(device: RenderDevice, scene: string, setting: Setting) {
    const { gl, precision, shaderOptions } = device;
    registerPaths(pathsOf(setting));
    this.#device = device;
    this.#scene = resolveScene(parseScene(JSON.parse(scene)), WIDTH / HEIGHT);
    const required = requirements(this.#scene, setting);
    // The assembler has left out the comments.
    this.shaderChars = generateShader(required, shaderOptions).fragment.replace(/\s+/g, '').length;
    // The key of a program does not tell from where on it plays roulette.
    this.#programs = new ProgramCache(gl);
    this.#tracer = new Tracer(gl, this.#programs, required, shaderOptions);
    this.#tracer.compile();
    this.#tracer.setScene(this.#scene);
    const [width, height] = [WIDTH, HEIGHT].map((side) => Math.round(side * setting.scale)) as [number, number];
    this.#target = new Accumulation(gl, precision, width, height);
    this.#meter = new NoiseMeter(gl, this.#programs, precision, this.#target);
    registerPaths(WHOLE_PATHS);
  }

  clear(): void {
    this.#target.clear();
  }

  /** Adds samples until there are so many. */
  drawTo(samples: number, seed: number): void {
    const { width, height } = this.#target;
    for (let sample = this.#target.samples; sample < samples; sample++) {
      const frame = cameraFrame(this.#scene.camera, width, height, pixelSample(sample, seed));
      this.#target.add(() => this.#tracer.draw(frame, { sample, seed }));
    }
  }

  wait(): void {
    const { gl } = this.#device;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, this.#pixel);
  }

  /** How noisy it says that it is. */
  estimate(): number {
    return this.#meter.begin(this.#target, 1)().error;
  }

  /** The mean of the samples at the size of what is shown, without coverage. */
  read(): Radiance {
    const { width, height } = this.#target;
    const mean = this.#target.readMean();
    return width === WIDTH ? mean.filter((_, i) => i % 4 < 3) : enlarged(mean, width, height);
  }

  dispose(): void {
    this.#meter.dispose();
    this.#target.dispose();
    this.#tracer.dispose();
  }
}

/** RGBA to RGB of the whole size: between four pixels, as browsers enlarge a canvas. */
function enlarged(mean: Float32Array, width: number, height: number): Radiance {
  const place = (at: number, from: number, to: number) => {
    const position = Math.min(Math.max(((at + 0.5) * from) / to - 0.5, 0), from - 1);
    const first = Math.min(Math.floor(position), from - 2);
    return { first, share: position - first };
  };
  const result = new Float32Array(3 * WIDTH * HEIGHT);
  for (let i = 0; i < result.length; i++) {
    const [pixel, channel] = [Math.floor(i / 3), i % 3];
    const x = place(pixel % WIDTH, width, WIDTH);
    const y = place(Math.floor(pixel / WIDTH), height, HEIGHT);
    const at = (right: number, down: number): number =>
      mean[4 * ((y.first + down) * width + x.first + right) + channel] as number;
    const above = at(0, 0) * (1 - x.share) + at(1, 0) * x.share;
    const below = at(0, 1) * (1 - x.share) + at(1, 1) * x.share;
    result[i] = above * (1 - y.share) + below * y.share;
  }
  return result;
}

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
  /** What the picture of each seed said that its noise was; of one sample nothing is known. */
  readonly estimates: readonly number[];
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
    estimates: [] as number[],
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
      if (stage.count > 1) stage.estimates.push(one.estimate());
    }
    seeds++;
  }
  const right = Array.from(converged.mean, shown);
  const points = gathered.map(({ count, spread, estimates, first = new Float32Array() }) => {
    const data = Array.from(first, shown);
    return {
      samples: count,
      ...noiseOf(spread, converged),
      estimates,
      psnr: psnr(data, right),
      flip: meanFlip({ width: WIDTH, height: HEIGHT, data }, { width: WIDTH, height: HEIGHT, data: right }),
    };
  });
  return { seeds, points, ...biasOf((gathered.at(-1) as (typeof gathered)[number]).spread, converged) };
}
