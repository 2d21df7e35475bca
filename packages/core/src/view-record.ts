/** What the shader is told of the eye and of what surrounds the scene. */
import type { CameraFrame } from './camera-frame.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { RecordValues } from './std140.ts';
import { add, scale, subtract } from './vector.ts';

/** Rays through the window; see `CameraFrame`. Width and height are the window's, in pixels. */
export const eyeRecord = [
  { name: 'corner', type: 'vec3' },
  { name: 'width', type: 'float', when: 'varyings' },
  { name: 'stepX', type: 'vec3' },
  { name: 'height', type: 'float', when: 'varyings' },
  { name: 'stepY', type: 'vec3' },
] as const;

export const packEye = ({ corner, width, stepX, height, stepY }: CameraFrame): RecordValues<typeof eyeRecord> => ({
  corner,
  width,
  stepX,
  height,
  stepY,
});

/** Radiance from all around is mean + y slope, y being the height of the unit direction. */
export const surroundingsRecord = [
  { name: 'background', type: 'vec3', when: 'backgroundColor' },
  { name: 'mean', type: 'vec3', when: 'environment' },
  { name: 'slope', type: 'vec3', when: 'gradient' },
] as const;

export function packSurroundings({ background, environment }: ResolvedScene): RecordValues<typeof surroundingsRecord> {
  const { top, bottom } = environment ?? { top: BLACK, bottom: BLACK };
  return {
    background: typeof background === 'string' ? BLACK : background,
    mean: scale(add(top, bottom), 0.5),
    slope: scale(subtract(top, bottom), 0.5),
  };
}

const BLACK = [0, 0, 0] as const;
