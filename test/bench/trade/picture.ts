/** A scene on the GPU as one setting draws it, with what the product does not let anyone choose. */
import '@ray-scene/core/parts';
// Bundled pages are without it otherwise, and then scenes at true scale are refused before anybody has looked closely.
import '../../../packages/core/src/words.ts';
import {
  cameraFrame,
  type EnvironmentImages,
  generateShader,
  parseScene,
  type ResolvedScene,
  requirements,
  resolveScene,
} from '@ray-scene/core';
import { type PathParts, pathParts, registerPaths } from '../../../packages/core/src/parts.ts';
import { Accumulation } from '../../../packages/ray-scene/src/accumulation.ts';
import { Display } from '../../../packages/ray-scene/src/display.ts';
import { NoiseMeter } from '../../../packages/ray-scene/src/noise-meter.ts';
import { ProgramCache } from '../../../packages/ray-scene/src/program-cache.ts';
import type { RenderDevice } from '../../../packages/ray-scene/src/render-device.ts';
import { SceneTextures } from '../../../packages/ray-scene/src/scene-textures.ts';
import { Tracer } from '../../../packages/ray-scene/src/tracer.ts';
import type { Setting } from './knobs.ts';
import type { Radiance } from './statistics.ts';

/** In pixels: whole cells. */
export const WIDTH = 96;
export const HEIGHT = 64;

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
export class Picture {
  readonly shaderChars: number;
  readonly #device: RenderDevice;
  readonly #programs: ProgramCache;
  readonly #scene: ResolvedScene;
  readonly #clamp: number | undefined;
  readonly #display: Display;
  readonly #context = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
  readonly #tracer: Tracer;
  readonly #target: Accumulation;
  readonly #meter: NoiseMeter;
  readonly #pixel = new Float32Array(4);

  constructor(device: RenderDevice, scene: string, setting: Setting, images?: EnvironmentImages) {
    const { gl, precision, shaderOptions } = device;
    registerPaths(pathsOf(setting));
    this.#device = device;
    this.#clamp = setting.clamp;
    this.#scene = resolveScene(parseScene(JSON.parse(scene)), WIDTH / HEIGHT, undefined, images);
    const required = requirements(this.#scene, setting);
    // The assembler has left out the comments.
    this.shaderChars = generateShader(required, shaderOptions).fragment.replace(/\s+/g, '').length;
    // The key of a program does not tell from where on it plays roulette.
    this.#programs = new ProgramCache(gl);
    this.#tracer = new Tracer(gl, this.#programs, required, shaderOptions);
    this.#tracer.compile();
    this.#tracer.setScene(this.#scene, SceneTextures);
    const [width, height] = [WIDTH, HEIGHT].map((side) => Math.round(side * setting.scale)) as [number, number];
    this.#target = new Accumulation(gl, precision, width, height);
    this.#meter = new NoiseMeter(gl, this.#programs, precision, this.#target);
    this.#display = new Display(gl, this.#programs, 'neutral');
    registerPaths(WHOLE_PATHS);
  }

  clear(): void {
    this.#target.clear();
  }

  /** Adds samples until there are so many. */
  drawTo(samples: number, seed: number): void {
    const { width, height } = this.#target;
    const frame = cameraFrame(this.#scene.camera, width, height);
    for (let sample = this.#target.samples; sample < samples; sample++) {
      this.#target.add(() => this.#tracer.draw(frame, { sample, seed, clamp: this.#clamp }));
    }
  }

  /** Shows what has been drawn on a canvas, as elements do with every frame. */
  show(): void {
    const { width, height } = this.#target;
    this.#device.present(this.#context, width, height, () => this.#display.draw(this.#target, 1));
  }

  /** Until all samples are drawn; while the target is bound, that is: before anything is shown. */
  wait(): void {
    const { gl } = this.#device;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, this.#pixel);
  }

  /** Until what was shown is on the canvas. */
  waitShown(): void {
    this.#context.getImageData(0, 0, 1, 1);
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
    this.#display.dispose();
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
