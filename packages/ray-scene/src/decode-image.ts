/** What a browser reads images as: linear RGB of what is sRGB in the file. */
import type { EnvironmentImage } from '@ray-scene/core';

/** More than any GPU takes. */
const MOST_PIXELS = 2 ** 25;

/** Linear values of the 256 that a channel may have. Source: IEC 61966-2-1:1999, section 5.2. */
const linear = Float32Array.from({ length: 256 }, (_, value) => {
  const c = value / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

/**
 * The image of a file, whatever its format is, without regard for transparency.
 * @throws {Error} when the browser reads none.
 */
export async function decodeImage(file: Blob): Promise<EnvironmentImage> {
  const bitmap = await createImageBitmap(file, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' }).catch(() => {
    throw new Error('it is no image that this browser reads');
  });
  const { width, height } = bitmap;
  if (width * height > MOST_PIXELS) throw new Error(`it has ${width} × ${height} pixels, more than ${MOST_PIXELS}`);
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas for it');
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const bytes = context.getImageData(0, 0, width, height).data;
  const data = new Float32Array(3 * width * height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    for (let c = 0; c < 3; c++) data[3 * pixel + c] = linear[bytes[4 * pixel + c] as number] as number;
  }
  return { width, height, data };
}
