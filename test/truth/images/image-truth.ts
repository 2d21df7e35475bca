/** A folder of `data/images`: a scene, and the picture that another renderer made of it. */
import type { NeutralScene } from './neutral-scene.ts';

export interface ImageTruth {
  readonly scene: NeutralScene;
  readonly width: number;
  readonly height: number;
  /** Independent pictures that the errors were estimated from. */
  readonly batches: number;
  /** Linear RGB, the top row first. */
  readonly rgb: Float32Array;
  /** Standard error of the grey mean (R + G + B) / 3 of each pixel. */
  readonly error: Float32Array;
  /** Standard error of the image's grey mean, relative to it. */
  readonly meanError: number;
}

/** Reads the file of that name as bytes. */
export type ReadFile = (name: string) => Promise<ArrayBuffer>;

export async function readImageTruth(read: ReadFile): Promise<ImageTruth> {
  const json = async (name: string): Promise<unknown> => JSON.parse(new TextDecoder().decode(await read(name)));
  const scene = (await json('scene.json')) as NeutralScene;
  const { width, height, batches, relStdErrOfImageMean } = (await json('reference.json')) as {
    readonly width: number;
    readonly height: number;
    readonly batches: number;
    readonly relStdErrOfImageMean: number;
  };
  return {
    scene,
    width,
    height,
    batches,
    rgb: floats(await read('reference.f32')),
    error: floats(await read('stderr.f32')),
    meanError: relStdErrOfImageMean,
  };
}

/** Little-endian, as are all machines that the tests run on. */
const floats = (bytes: ArrayBuffer): Float32Array => new Float32Array(bytes);
