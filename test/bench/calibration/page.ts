/**
 * What the bench of calibration does in a page: draws a scene again and again with other random numbers. How the pictures
 * differ is their true noise, and each of them says how noisy it thinks that it is.
 */
import { RenderDevice } from '../../../packages/ray-scene/src/render-device.ts';
import { type PackedImage, unpackedImages } from '../../truth/images/packed-image.ts';
import { BASE } from '../trade/knobs.ts';
import { Picture } from '../trade/picture.ts';
import { Spread } from '../trade/statistics.ts';
import { noisyPixels, relativeNoise, tailIndex } from './tail.ts';

export interface Subject {
  /** JSON text. */
  readonly scene: string;
  readonly images: readonly PackedImage[];
  readonly integrator: 'path' | 'direct';
  readonly bounces: number;
}

/** How many pictures are looked at when they have so many samples. */
export interface Stage {
  readonly samples: number;
  readonly seeds: number;
}

export interface Task {
  readonly subject: Subject;
  /** With more samples, not more pictures. */
  readonly stages: readonly Stage[];
}

export interface Known {
  /** By the stages. */
  readonly noise: readonly number[];
  /** How many pixels hold it. */
  readonly pixels: readonly number[];
  /** What each picture said, over what was true. */
  readonly ratios: readonly (readonly number[])[];
  /** Of the pictures with the most samples. */
  readonly tailIndex: number;
}

let device: RenderDevice | undefined;

export function calibrate({ subject, stages: planned }: Task): Known {
  const { scene, images, integrator, bounces } = subject;
  device ??= new RenderDevice();
  const picture = new Picture(device, scene, { ...BASE, integrator, bounces }, unpackedImages(images));
  const stages = planned.map((stage) => ({ ...stage, pictures: [] as Float32Array[], told: [] as number[] }));
  for (let seed = 0; stages.some(({ seeds }) => seed < seeds); seed++) {
    picture.clear();
    for (const { samples, seeds, pictures, told } of stages) {
      if (seed >= seeds) break;
      picture.drawTo(samples, seed);
      told.push(picture.estimate());
      pictures.push(picture.read());
    }
  }
  picture.dispose();
  const spreads = stages.map(({ pictures }) => spreadOf(pictures));
  const best = spreads.at(-1) as Spread;
  const noise = spreads.map((spread) => relativeNoise(spread, best));
  const ratios = stages.map(({ told }, i) => told.map((error) => error / (noise[i] as number)));
  const pixels = spreads.map((spread) => noisyPixels(spread, best));
  return { noise, pixels, ratios, tailIndex: tailIndex(stages.at(-1)?.pictures ?? [], best) };
}

function spreadOf(pictures: readonly Float32Array[]): Spread {
  const spread = new Spread(pictures[0]?.length ?? 0);
  for (const one of pictures) spread.add(one);
  return spread;
}
