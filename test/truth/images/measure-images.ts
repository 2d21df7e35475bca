/** All pictures of a folder, rendered by us and judged. */
import { mkdirSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { type EnvironmentImages, parseScene, SceneError } from '@ray-scene/core';
import type { Gpu } from '../gpu-side.ts';
import { differencePicture } from './difference-picture.ts';
import { type Estimate, type EstimateOptions, estimate, inTurns, type RenderBatch } from './estimate.ts';
import { type ImageTruth, readImageTruth } from './image-truth.ts';
import { errorRatio, type ImageRow, type ImageSide, imageRow, moreSamples, skippedRow } from './judge-image.ts';
import { packedImages } from './packed-image.ts';
import { ReferencePool } from './reference-pool.ts';
import { environmentImages } from './translate-environment.ts';
import { type TranslatedScene, translateScene } from './translate-scene.ts';

export interface ImageOptions {
  /** Folder with a folder for each scene. */
  readonly data: string;
  /** Only this one is measured. */
  readonly scene?: string | undefined;
  /** Rows of an earlier run, of whatever scene and side: they stand as they are. */
  readonly known: readonly ImageRow[];
  readonly onCpu: boolean;
  readonly gpu: Gpu | undefined;
  /** Per pixel, at most. */
  readonly mostSamples: number;
  /** What our mean standard errors may be, in units of theirs. */
  readonly mostErrors: number;
  /** Folder for pictures of the differences. */
  readonly pictures?: string | undefined;
  /** Told what is being done, for whoever waits. */
  readonly onProgress: (what: string) => void;
  /** Told of each new row, and of all so far: who is interrupted has these. */
  readonly onRow: (row: ImageRow, rows: readonly ImageRow[]) => void;
}

/** How often it is told how far a round has come. */
const PROGRESS_MS = 15_000;

type Renderable = Exclude<TranslatedScene, { readonly skipped: string }>;

/** Makes a scene ready to be rendered. */
type Renderer = (scene: Renderable) => Promise<RenderBatch>;

export async function measureImages(options: ImageOptions): Promise<readonly ImageRow[]> {
  const { data, gpu, onRow } = options;
  const pool = options.onCpu ? new ReferencePool() : undefined;
  const rows = [...options.known];
  try {
    for (const name of sceneNames(options)) {
      const truth = await imageTruth(join(data, name));
      const images = await environmentImages(truth.scene, (file) => bytesOf(join(data, file)));
      const sides: readonly (readonly [ImageSide, Renderer | undefined])[] = [
        ['reference', pool && ((scene) => onPool(pool, scene, truth, images))],
        ['gpu', gpu && ((scene) => onGpu(gpu, scene, truth, images))],
      ];
      for (const [side, renderer] of sides) {
        if (!renderer || rows.some((row) => row.scene === name && row.side === side)) continue;
        const row = await measureImage(side, truth, options, renderer);
        rows.push(row);
        rows.sort(inOrder);
        onRow(row, rows);
      }
    }
  } finally {
    await pool?.close();
  }
  return rows;
}

/** By scene; the reference before the GPU. */
const inOrder = (a: ImageRow, b: ImageRow): number => a.scene.localeCompare(b.scene) || b.side.localeCompare(a.side);

function sceneNames({ data, scene }: ImageOptions): readonly string[] {
  const names = readdirSync(data).filter((name) => statSync(join(data, name)).isDirectory());
  names.sort();
  if (scene !== undefined && !names.includes(scene)) {
    throw new Error(`--scene takes ${names.join(', ')}, not ${scene}`);
  }
  return scene === undefined ? names : [scene];
}

const imageTruth = (folder: string): Promise<ImageTruth> => readImageTruth((name) => bytesOf(join(folder, name)));

const bytesOf = async (file: string): Promise<ArrayBuffer> => new Uint8Array(await readFile(file)).buffer;

async function measureImage(
  side: ImageSide,
  truth: ImageTruth,
  options: ImageOptions,
  renderer: Renderer,
): Promise<ImageRow> {
  const { name } = truth.scene;
  const translated = translateScene(truth.scene);
  if (translated.skipped !== undefined) return skippedRow(name, side, translated.skipped);
  try {
    parseScene(translated.scene);
    const start = performance.now();
    const ours = await estimate(await renderer(translated), {
      more: (one) => moreSamples(one, truth, options.mostErrors),
      mostSamples: options.mostSamples,
      ...progress(`${name} ${side}`, truth, options.onProgress),
    });
    if (options.pictures) savePicture(join(options.pictures, `${name}-${side}.png`), ours, truth);
    return imageRow(side, ours, truth, options.mostErrors, (performance.now() - start) / 60_000);
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
  await gpu.show({ scene: JSON.stringify(scene), images: packedImages(images), bounces, width, height });
  return inTurns((seed, samples) => gpu.samples(seed, samples));
}

/** Tells at the end of each round how good the picture is, and now and then when a longer round ends. */
function progress(
  what: string,
  truth: ImageTruth,
  tell: ImageOptions['onProgress'],
): Pick<EstimateOptions, 'onRound' | 'onBatch'> {
  const start = performance.now();
  let [round, told] = [start, start];
  return {
    onRound(ours) {
      round = told = performance.now();
      const ratio = errorRatio(ours, truth).toPrecision(3);
      tell(`${what}: ${ours.samples} samples, errors ${ratio} times theirs, ${seconds(round - start)}`);
    },
    onBatch(done, batches, samples) {
      const now = performance.now();
      if (done === batches || now - told < PROGRESS_MS) return;
      told = now;
      const left = seconds(((now - round) / done) * (batches - done));
      tell(`${what}: ${done} of ${batches} × ${samples} samples, ${left} to go`);
    },
  };
}

const seconds = (milliseconds: number): string => `${(milliseconds / 1000).toFixed(0)} s`;

function savePicture(file: string, ours: Estimate, truth: ImageTruth): void {
  mkdirSync(join(file, '..'), { recursive: true });
  writeFileSync(file, differencePicture(ours, truth));
}
