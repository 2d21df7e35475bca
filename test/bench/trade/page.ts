/**
 * What the measurement of the trade does in a page: draws a scene with all its settings, many times with other random
 * numbers, and keeps the pictures here: only numbers leave.
 */
import { RenderDevice } from '../../../packages/ray-scene/src/render-device.ts';
import { meanFlipTo } from './flip.ts';
import { CONVERGED, DIRECT, isPaired, PAIRED, type Setting } from './knobs.ts';
import { HEIGHT, Picture, WIDTH } from './picture.ts';
import {
  type Bias,
  biasOf,
  type Noise,
  noiseOf,
  psnr,
  type Radiance,
  Spread,
  shown,
  type Yardstick,
  yardstickOf,
} from './statistics.ts';

const devices: { [T in Setting['target']]?: RenderDevice } = {};

function deviceOf(target: Setting['target']): RenderDevice {
  devices[target] ??= new RenderDevice({ precision: target });
  return devices[target];
}

const NUMBERS = 3 * WIDTH * HEIGHT;

/** Samples after which nothing is new: from the third on they are added to others, which drivers may compile for. */
const WARM = 4;

let scene = '';
/** By the settings that have been opened, in that order. */
const pictures: { readonly picture: Picture; readonly setting: Setting }[] = [];

export function begin(task: { readonly scene: string }): void {
  scene = task.scene;
}

/** From the parsed scene to the first pixel that can be read, in a context that is there. Settings stay open. */
export function open(setting: Setting): {
  readonly compileMs: number;
  readonly firstFrameMs: number;
  readonly shaderChars: number;
} {
  const device = deviceOf(setting.target);
  const start = performance.now();
  const picture = new Picture(device, scene, setting);
  const compiled = performance.now();
  picture.drawTo(1, 0);
  picture.wait();
  const firstFrameMs = performance.now() - start;
  pictures.push({ picture, setting });
  return { compileMs: compiled - start, firstFrameMs, shaderChars: picture.shaderChars };
}

/** Does what takes longer the first time, and returns how many milliseconds a sample takes. */
export function warmUp({ index }: Pick<Turn, 'index'>): number {
  run({ index, samples: WARM, shows: true });
  return run({ index, samples: WARM, shows: false }) / WARM;
}

export interface Turn {
  /** Which of the settings, in the order in which they were opened. */
  readonly index: number;
  readonly samples: number;
  /** Whether each sample is shown, as a frame. */
  readonly shows: boolean;
}

/** Draws so many samples and waits for them; returns how many milliseconds passed. */
export function run({ index, samples, shows }: Turn): number {
  const { picture } = opened(index);
  const start = performance.now();
  picture.clear();
  for (let sample = 1; sample <= samples; sample++) {
    picture.drawTo(sample, 0);
    if (shows) picture.show();
  }
  if (shows) picture.waitShown();
  else picture.wait();
  return performance.now() - start;
}

const opened = (index: number): (typeof pictures)[number] => pictures[index] as (typeof pictures)[number];

/** So that no other picture has the random numbers of the converged ones. */
const FIRST_SEED = 1000;

/** The one that is open, so that it is not compiled again, or another. */
function pictureOf(setting: Setting): Picture {
  const same = pictures.find((one) => JSON.stringify(one.setting) === JSON.stringify(setting));
  return same?.picture ?? new Picture(deviceOf(setting.target), scene, setting);
}

/** Draws pictures of many samples. */
class Converging {
  readonly #setting: Setting;
  #picture: Picture | undefined;
  /** Alternating ones: those that the yardstick is made of, and those that errors are differences to. */
  readonly spreads = [new Spread(NUMBERS), new Spread(NUMBERS)] as const;
  runs = 0;

  constructor(setting: Setting) {
    this.#setting = setting;
  }

  draw(samples: number, seed: number): Radiance {
    this.#picture ??= pictureOf(this.#setting);
    this.#picture.clear();
    this.#picture.drawTo(samples, seed);
    return this.#picture.read();
  }

  add(samples: number): void {
    (this.spreads[this.runs % 2] as Spread).add(this.draw(samples, FIRST_SEED + this.runs));
    this.runs++;
  }

  mean(i: number): number {
    return this.spreads.reduce((sum, spread) => sum + spread.mean(i) * spread.count, 0) / this.runs;
  }
}

/** By `path` what is right; by `direct` which pixels are rare there, where highlights are sharper. */
const converging = { path: new Converging(CONVERGED), direct: new Converging(DIRECT) };

/** With few samples, by their seeds. */
const partners: Radiance[] = [];

/** How many milliseconds a sample of a converged picture takes. */
export function paceOf(integrator: Setting['integrator']): number {
  converging[integrator].draw(WARM, 0);
  const [samples, start] = [8, performance.now()];
  converging[integrator].draw(samples, 0);
  return (performance.now() - start) / samples;
}

/** Draws another picture. */
export function converge({ integrator, samples }: Pick<Setting, 'integrator'> & { readonly samples: number }): void {
  converging[integrator].add(samples);
}

interface Right {
  readonly yardstick: Yardstick;
  readonly pictures: Spread;
  /** The mean of all of them, as it is shown. */
  readonly shown: readonly number[];
  readonly flipTo: ReturnType<typeof meanFlipTo>;
}

let right: Right | undefined;

/** Ends the drawing of what is right. Returns how noisy the mean of it is. */
export function judgeBy(): { readonly noise: number } {
  const { path, direct } = converging;
  const [judges, others] = path.spreads;
  const data = Array.from({ length: NUMBERS }, (_, i) => shown(path.mean(i)));
  const yardstick = yardstickOf(judges, direct.spreads[0]);
  right = { yardstick, pictures: others, shown: data, flipTo: meanFlipTo({ width: WIDTH, height: HEIGHT, data }) };
  return { noise: noiseOf(others, yardstick).noise / Math.sqrt(path.runs) };
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
  readonly index: number;
  readonly samples: readonly number[];
  /** How many pictures are drawn, at least two. Of more than `PAIRED` samples there are two. */
  readonly seeds: number;
}

/** Draws a setting again and again, with other random numbers each time. */
export function measure({ index, samples, seeds }: Task): Accuracy {
  const { picture, setting } = opened(index);
  const { yardstick, pictures: held } = right as Right;
  const stages = samples.map((count) => ({ count, pictures: [] as Radiance[] }));
  for (let seed = 0; seed < seeds; seed++) {
    picture.clear();
    for (const { count, pictures: drawn } of stages) {
      if (count > PAIRED && seed >= 2) continue;
      picture.drawTo(count, seed);
      drawn.push(picture.read());
    }
  }
  const points = stages.map(({ count, pictures: drawn }) => ({
    samples: count,
    ...noiseOf(spreadOf(drawn), yardstick),
    ...likeness(drawn[0] as Radiance, right as Right),
  }));
  const drawnOf = (stage: (typeof stages)[number] | undefined): readonly Radiance[] => stage?.pictures ?? [];
  const bias = isPaired(setting)
    ? biasOf(spreadOf(drawnOf(stages.find(({ count }) => count === PAIRED)).map(differenceToRight)), yardstick)
    : biasOf(spreadOf(drawnOf(stages.at(-1))), yardstick, held);
  return { seeds, points, ...bias };
}

function differenceToRight(radiance: Radiance, seed: number): Radiance {
  partners[seed] ??= converging.path.draw(PAIRED, seed);
  const partner = partners[seed];
  return radiance.map((value, i) => value - (partner[i] as number));
}

function spreadOf(all: readonly Radiance[]): Spread {
  const spread = new Spread(NUMBERS);
  for (const one of all) spread.add(one);
  return spread;
}

function likeness(radiance: Radiance, { shown: wanted, flipTo }: Right): Pick<Point, 'psnr' | 'flip'> {
  const data = Array.from(radiance, shown);
  return { psnr: psnr(data, wanted), flip: flipTo({ width: WIDTH, height: HEIGHT, data }) };
}
