/** What the bench does in a page: draws a scene, or its floor, into a float target, with the renderer's own parts. */
import '@ray-scene/core/parts';
// Bundled pages are without it otherwise, and then scenes at true scale are refused before anybody has looked closely.
import '../../packages/core/src/words.ts';
import {
  type CameraFrame,
  cameraFrame,
  generateShader,
  parseScene,
  type ResolvedScene,
  requirements,
  resolveScene,
  type SampleNumber,
  type Scene,
} from '@ray-scene/core';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { Tracer } from '../../packages/ray-scene/src/tracer.ts';
import { type PackedImage, unpackedImages } from '../truth/images/packed-image.ts';
import { FloorTracer } from './floor-tracer.ts';

/** One picture to draw. */
export interface Subject {
  /** JSON text of the scene. */
  readonly scene: string;
  readonly integrator: 'path' | 'direct';
  readonly bounces: number;
  readonly clamp?: number;
  /** What the scene asks for. */
  readonly images?: readonly PackedImage[];
  /** In pixels; the picture is square. */
  readonly size: number;
  /** Source of the shader to draw it with, instead of the generated one. */
  readonly floor?: string;
}

interface Drawable {
  draw(frame: CameraFrame, sample: SampleNumber): void;
}

const resolvedOf = (scene: Scene, { images }: Subject): ResolvedScene =>
  resolveScene(scene, 1, undefined, unpackedImages(images));

/** A subject on the GPU. */
class Picture {
  readonly #gl: WebGL2RenderingContext;
  readonly #scene: ResolvedScene;
  readonly #drawable: Drawable;
  readonly #accumulation: Accumulation;
  readonly #pixel = new Float32Array(4);

  constructor({ gl, precision, programs, shaderOptions }: RenderDevice, scene: Scene, subject: Subject) {
    this.#gl = gl;
    this.#scene = resolvedOf(scene, subject);
    if (subject.floor) {
      this.#drawable = new FloorTracer(gl, subject.floor);
    } else {
      const tracer = new Tracer(gl, programs, requirements(this.#scene, subject), shaderOptions);
      tracer.compile();
      tracer.setScene(this.#scene);
      this.#drawable = tracer;
    }
    this.#accumulation = new Accumulation(gl, precision, subject.size, subject.size);
  }

  /** Draws so many samples of a new picture, and waits for the last one. */
  draw(samples: number): void {
    const { width, height } = this.#accumulation;
    this.#accumulation.clear();
    const frame = cameraFrame(this.#scene.camera, width, height);
    for (let i = 0; i < samples; i++) {
      this.#accumulation.add(() => this.#drawable.draw(frame, { sample: i, seed: 0 }));
    }
    this.#gl.readPixels(0, 0, 1, 1, this.#gl.RGBA, this.#gl.FLOAT, this.#pixel);
  }

  /** The mean of what was drawn. */
  read(): Float32Array {
    return this.#accumulation.readMean();
  }
}

/** From a parsed scene to the first pixel that can be read. */
export function coldStart(subject: Subject): { readonly compileMs: number; readonly firstFrameMs: number } {
  const device = new RenderDevice();
  const scene = parseScene(subject.scene);
  const start = performance.now();
  const picture = new Picture(device, scene, subject);
  const compiled = performance.now();
  picture.draw(1);
  const drawn = performance.now();
  device.dispose();
  return { compileMs: compiled - start, firstFrameMs: drawn - start };
}

let device: RenderDevice;
let pictures: readonly Picture[] = [];

/** Puts subjects on one device, for `run`. Returns how long the generated shader of the first one is. */
export function prepare(subjects: readonly Subject[]): { readonly shaderChars: number } {
  device ??= new RenderDevice();
  pictures = subjects.map((subject) => new Picture(device, parseScene(subject.scene), subject));
  const [first] = subjects as [Subject];
  const required = requirements(resolvedOf(parseScene(first.scene), first), first);
  // The assembler has left out the comments.
  return { shaderChars: generateShader(required, device.shaderOptions).fragment.replace(/\s+/g, '').length };
}

/** Draws samples of a subject; returns how many milliseconds passed. */
export function run(index: number, samples: number): number {
  const start = performance.now();
  pictures[index]?.draw(samples);
  return performance.now() - start;
}

/** The median, over the pixels that show anything, of how far two subjects are apart, relative to the largest channel. */
export function difference(): number {
  const [a, b] = pictures.map((picture) => {
    picture.draw(4);
    return picture.read();
  }) as [Float32Array, Float32Array];
  const relative: number[] = [];
  for (let i = 0; i < a.length; i += 4) {
    const [x, y] = [a.subarray(i, i + 3), b.subarray(i, i + 3)];
    const largest = Math.max(...x);
    if (largest > 0) relative.push(Math.max(...x.map((value, j) => Math.abs(value - (y[j] as number)))) / largest);
  }
  return relative.sort((one, other) => one - other)[relative.length >> 1] as number;
}

/** What draws, as far as the browser tells. */
export function rendererName(): string {
  const { gl } = new RenderDevice();
  const extension = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
}
