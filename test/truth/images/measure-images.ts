/** All pictures of a folder, rendered by us and judged. */
import { mkdirSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { type EnvironmentImages, parseScene, SceneError } from '@ray-scene/core';
import type { Gpu } from '../gpu-side.ts';
import { differencePicture } from './difference-picture.ts';
import { type Estimate, estimate, inTurns, type RenderBatch } from './estimate.ts';
import { type ImageTruth, readImageTruth } from './image-truth.ts';
import { errorRatio, type ImageRow, type ImageSide, imageRow, moreSamples, skippedRow } from './judge-image.ts';
import { ReferencePool } from './reference-pool.ts';
import { environmentImages } from './translate-environment.ts';
import { type TranslatedScene, translateScene } from './translate-scene.ts';

export interface ImageOptions {
  /** Folder with a folder for each scene. */
  readonly data: string;
  /** Only this one. */
  readonly scene?: string | undefined;
  readonly onCpu: boolean;
  readonly gpu: Gpu | undefined;
  /** Per pixel, at most. */
  readonly mostSamples: number;
  /** Folder for pictures of the differences. */
  readonly pictures?: string | undefined;
  /** Told what is being done, for whoever waits. */
  readonly onProgress: (what: string) => void;
}

type Renderable = Exclude<TranslatedScene, { readonly skipped: string }>;

export async function measureImages(options: ImageOptions): Promise<readonly ImageRow[]> {
  const names = sceneNames(options);
  const pool = options.onCpu ? new ReferencePool() : undefined;
  const rows: ImageRow[] = [];
  try {
    for (const name of names) {
      const truth = await imageTruth(join(options.data, name));
      const images = await environmentImages(truth.scene, (file) => bytesOf(join(options.data, file)));
      const translated = translateScene(truth.scene);
      if (pool) {
        rows.push(
          await measureImage('reference', truth, translated, options, (scene) => onPool(pool, scene, truth, images)),
        );
      }
      const { gpu } = options;
      if (gpu)
        rows.push(await measureImage('gpu', truth, translated, options, (scene) => onGpu(gpu, scene, truth, images)));
    }
  } finally {
    await pool?.close();
  }
  return rows;
}

function sceneNames({ data, scene }: ImageOptions): readonly string[] {
  const names = readdirSync(data).filter((name) => statSync(join(data, name)).isDirectory());
  if (scene !== undefined && !names.includes(scene)) {
    throw new Error(`--scene takes ${names.join(', ')}, not ${scene}`);
  }
  return scene === undefined ? names.sort() : [scene];
}

const imageTruth = (folder: string): Promise<ImageTruth> => readImageTruth((name) => bytesOf(join(folder, name)));

const bytesOf = async (file: string): Promise<ArrayBuffer> => new Uint8Array(await readFile(file)).buffer;

async function measureImage(
  side: ImageSide,
  truth: ImageTruth,
  translated: TranslatedScene,
  options: ImageOptions,
  renderer: (scene: Renderable) => Promise<RenderBatch>,
): Promise<ImageRow> {
  const { name } = truth.scene;
  if (translated.skipped !== undefined) return skippedRow(name, side, translated.skipped);
  try {
    parseScene(translated.scene);
    const start = performance.now();
    const ours = await estimate(await renderer(translated), {
      more: (one) => moreSamples(one, truth),
      mostSamples: options.mostSamples,
      onRound: (one) => options.onProgress(progress(side, one, truth, performance.now() - start)),
    });
    if (options.pictures) savePicture(join(options.pictures, `${name}-${side}.png`), ours, truth);
    return imageRow(side, ours, truth);
  } catch (error) {
    // A scene that our language has no words for should be translated in another way.
    if (error instanceof SceneError) return skippedRow(name, side, error.message, true);
    throw error;
  }
}

const onPool = async (
  pool: ReferencePool,
  { scene, bounces }: Renderable,
  truth: ImageTruth,
  images: EnvironmentImages,
): Promise<RenderBatch> => {
  const { width, height } = truth;
  return (seed, samples) => pool.render({ scene, images, bounces, width, height, seed, samples });
};

async function onGpu(
  gpu: Gpu,
  { scene, bounces }: Renderable,
  { width, height }: ImageTruth,
  images: EnvironmentImages,
): Promise<RenderBatch> {
  const packed = [...images].map(([src, { data, ...size }]) => {
    return { src, ...size, data: Buffer.from(data.buffer).toString('base64') };
  });
  await gpu.show({ scene: JSON.stringify(scene), images: packed, bounces, width, height });
  return inTurns((seed, samples) => gpu.samples(seed, samples));
}

function progress(side: ImageSide, ours: Estimate, truth: ImageTruth, milliseconds: number): string {
  const ratio = errorRatio(ours, truth).toPrecision(3);
  const seconds = (milliseconds / 1000).toFixed(0);
  return `${truth.scene.name} ${side}: ${ours.samples} samples, errors ${ratio} times theirs, ${seconds} s`;
}

function savePicture(file: string, ours: Estimate, truth: ImageTruth): void {
  mkdirSync(join(file, '..'), { recursive: true });
  writeFileSync(file, differencePicture(ours, truth));
}
