/** Images on their way into a page, which takes JSON. */
import type { EnvironmentImage, EnvironmentImages } from '@ray-scene/core';

export interface PackedImage extends Omit<EnvironmentImage, 'data'> {
  readonly src: string;
  /** The numbers as base64 of their bytes. */
  readonly data: string;
}

/** In Node. */
export const packedImages = (images: EnvironmentImages): readonly PackedImage[] =>
  [...images].map(([src, { data, ...size }]) => {
    return { src, ...size, data: Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString('base64') };
  });

/** In the page. */
export const unpackedImages = (images: readonly PackedImage[] = []): EnvironmentImages =>
  new Map(images.map(({ src, data, ...size }) => [src, { ...size, data: floats(data) }]));

const floats = (text: string): Float32Array =>
  new Float32Array(Uint8Array.from(atob(text), (character) => character.charCodeAt(0)).buffer);
