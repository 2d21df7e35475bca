/** What `npm run truth` does in a page for pictures: the renderer that draws for the element, sample by sample. */
import '@ray-scene/core/parts';
import { parseScene, parseSettings } from '@ray-scene/core';
import { Renderer } from '../../../packages/ray-scene/src/renderer.ts';
import { type PackedImage, unpackedImages } from './packed-image.ts';

/** What the GPU draws until the next one. */
export interface GpuPicture {
  /** JSON text of the scene. */
  readonly scene: string;
  /** What the scene asks for. */
  readonly images?: readonly PackedImage[];
  readonly bounces: number;
  readonly width: number;
  readonly height: number;
}

let renderer: Renderer | undefined;
let bounces = 0;
let samples = 0;
let failure: Error | undefined;
/** When what a picture waits for is there. */
let loaded: Promise<void> | undefined;

/** For so long it may wait. */
const PATIENCE_MS = 10_000;

export function showPicture(picture: GpuPicture): void {
  renderer?.dispose();
  failure = undefined;
  bounces = picture.bounces;
  renderer = new Renderer(document.createElement('canvas'));
  renderer.onerror = (error) => {
    failure = error;
  };
  const { promise, resolve } = withTimeout();
  loaded = promise;
  renderer.onrestored = resolve;
  renderer.setScene(parseScene(picture.scene), unpackedImages(picture.images));
  renderer.resize(picture.width, picture.height);
}

function withTimeout(): { readonly promise: Promise<void>; readonly resolve: () => void } {
  let resolve = (): void => {};
  const promise = new Promise<void>((done) => {
    resolve = done;
    setTimeout(done, PATIENCE_MS);
  });
  return { promise, resolve };
}

/** Begins a picture with other random numbers. */
export function beginSamples(settings: { readonly seed: number; readonly samples: number }): void {
  samples = settings.samples;
  renderer?.setSettings(parseSettings({ ...settings, bounces, integrator: 'path' }));
}

/** Draws for about so many milliseconds; whether that was all. */
export async function drawSamples(milliseconds: number): Promise<boolean> {
  const end = performance.now() + milliseconds;
  while (performance.now() < end) {
    const wantsMore = renderer?.draw(50);
    if (failure) throw failure;
    if (!wantsMore && renderer?.samples !== samples) {
      if (!loaded) throw new Error('the GPU gave up');
      await loaded;
      loaded = undefined;
      continue;
    }
    if (!wantsMore) return true;
    // How long the GPU takes is learnt between tasks.
    await new Promise((resolve) => setTimeout(resolve));
  }
  return false;
}

/** The mean of the samples: linear RGBA, the top row first. */
export const readRadiance = (): Float32Array => renderer?.readRadiance() ?? new Float32Array(0);

/** The mean of the samples, RGBA, as base64 of its bytes: text that JSON keeps to the last bit. */
export function readPicture(): string {
  const bytes = new Uint8Array(readRadiance().buffer);
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
