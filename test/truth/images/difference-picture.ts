/** What to look at where two pictures do not agree: ours, theirs, and how surely they differ, side by side. */
import type { Estimate } from './estimate.ts';
import type { ImageTruth } from './image-truth.ts';
import { encoded, zScores } from './judge-image.ts';
import { png } from './png.ts';

/** Pixels of the file for one of the picture. */
const ZOOM = 3;
/** z that is shown in full colour. */
const FULL = 5;

/** On the right: red where ours is too bright, blue where it is too dark, black where they agree, white if not finite. */
export function differencePicture(ours: Estimate, theirs: ImageTruth): Buffer {
  const { width, height } = theirs;
  const z = zScores(ours, theirs);
  const panels = [shown(ours.rgb), shown(theirs.rgb), (pixel: number) => colorOf(z[pixel] as number)];
  const rgb = new Uint8Array(ZOOM * ZOOM * width * height * panels.length * 3);
  let at = 0;
  for (let y = 0; y < height * ZOOM; y++) {
    for (const panel of panels) {
      for (let x = 0; x < width * ZOOM; x++) {
        rgb.set(panel(Math.floor(y / ZOOM) * width + Math.floor(x / ZOOM)), at);
        at += 3;
      }
    }
  }
  return png(width * ZOOM * panels.length, height * ZOOM, rgb);
}

const shown =
  (rgb: ArrayLike<number>) =>
  (pixel: number): readonly number[] =>
    [0, 1, 2].map((c) => Math.round(255 * encoded(rgb[3 * pixel + c] as number)));

function colorOf(z: number): readonly number[] {
  if (!Number.isFinite(z)) return [255, 255, 255];
  const strength = Math.round(255 * Math.min(1, Math.abs(z) / FULL));
  return z > 0 ? [strength, 0, 0] : [0, 0, strength];
}
