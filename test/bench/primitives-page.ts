/**
 * What `npm run bench -- --primitives` does in a page: draws shapes of one kind by the engine's formulas, and once more by
 * those of a textbook (`textbook/KIND.glsl`), which stand in for the shader file of that kind and read the same record.
 */
import '@ray-scene/core/parts';
import {
  cameraFrame,
  parseScene,
  type ResolvedScene,
  requirements,
  resolveScene,
  type ShapeKind,
} from '@ray-scene/core';
import { moreParts, registerParts } from '../../packages/core/src/parts.ts';
import { Accumulation } from '../../packages/ray-scene/src/accumulation.ts';
import { ProgramCache } from '../../packages/ray-scene/src/program-cache.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { Tracer } from '../../packages/ray-scene/src/tracer.ts';
import box from './textbook/box.glsl';
import cone from './textbook/cone.glsl';
import cylinder from './textbook/cylinder.glsl';
import disc from './textbook/disc.glsl';
import plane from './textbook/plane.glsl';
import quad from './textbook/quad.glsl';
import sphere from './textbook/sphere.glsl';
import torus from './textbook/torus.glsl';
import triangle from './textbook/triangle.glsl';

const textbook: { readonly [K in ShapeKind]: string } = {
  sphere,
  plane,
  disc,
  quad,
  box,
  cylinder,
  cone,
  torus,
  triangle,
};

/** Shapes of one kind, to be drawn in both ways. */
export interface Subject {
  readonly kind: ShapeKind;
  /** JSON text of the scene. */
  readonly scene: string;
  /** In pixels; the picture is square. */
  readonly size: number;
}

class Picture {
  readonly #device: RenderDevice;
  readonly #scene: ResolvedScene;
  readonly #tracer: Tracer;
  readonly #target: Accumulation;
  readonly #pixel = new Float32Array(4);

  constructor(device: RenderDevice, { scene, size }: Subject) {
    const { gl, precision, shaderOptions } = device;
    this.#device = device;
    this.#scene = resolveScene(parseScene(scene));
    // The key of a program does not tell whose formulas are in it.
    this.#tracer = new Tracer(
      gl,
      new ProgramCache(gl),
      requirements(this.#scene, { bounces: 1, integrator: 'direct' }),
      shaderOptions,
    );
    this.#tracer.compile();
    this.#tracer.setScene(this.#scene);
    this.#target = new Accumulation(gl, precision, size, size);
  }

  /** Draws so many samples of a new picture, and waits for the last one. */
  draw(samples: number): void {
    const { width, height } = this.#target;
    this.#target.clear();
    const frame = cameraFrame(this.#scene.camera, width, height);
    for (let i = 0; i < samples; i++) {
      this.#target.add(() => this.#tracer.draw(frame, { sample: i, seed: 0 }));
    }
    const { gl } = this.#device;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, this.#pixel);
  }

  read(): Float32Array {
    return this.#target.readMean();
  }
}

let device: RenderDevice | undefined;
let pictures: readonly Picture[] = [];

/** Puts both ways to draw a subject on the GPU: 0 is the engine's, 1 the textbook's. Returns how far they are apart. */
export function prepare(subject: Subject): { readonly medianDifference: number } {
  device ??= new RenderDevice();
  const ours = new Picture(device, subject);
  const parts = moreParts();
  registerParts({ ...parts, files: { ...parts.files, [`shape/${subject.kind}.glsl`]: textbook[subject.kind] } });
  const theirs = new Picture(device, subject);
  registerParts(parts);
  pictures = [ours, theirs];
  const [a, b] = pictures.map((picture) => {
    picture.draw(1);
    return picture.read();
  }) as [Float32Array, Float32Array];
  // Not the coverage, every fourth number: it is 1 everywhere.
  const lit = [...a.keys()].filter((i) => i % 4 < 3 && (a[i] as number) > 0);
  const differences = lit.map((i) => Math.abs((a[i] as number) - (b[i] as number)) / (a[i] as number));
  return { medianDifference: differences.sort((x, y) => x - y)[lit.length >> 1] ?? Number.POSITIVE_INFINITY };
}

/** Draws samples; returns how many milliseconds passed. */
export function run(index: number, samples: number): number {
  const start = performance.now();
  pictures[index]?.draw(samples);
  return performance.now() - start;
}
