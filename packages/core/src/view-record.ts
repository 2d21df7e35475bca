/** What the shader is told of the eye and of what surrounds the scene. */
import type { CameraFrame } from './camera-frame.ts';
import { sequenceSeed } from './random.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { RecordValues } from './std140.ts';
import { add, subtract, scale as times, type Vec3 } from './vector.ts';

/** Rays through the window; see `CameraFrame`. Width and height are the window's, in pixels. */
export const eyeRecord = [
  { name: 'corner', type: 'vec3' },
  { name: 'width', type: 'float', when: 'varyings' },
  { name: 'stepX', type: 'vec3' },
  { name: 'height', type: 'float', when: 'varyings' },
  { name: 'stepY', type: 'vec3' },
  { name: 'forward', type: 'vec3', when: 'orthographic' },
  { name: 'lensX', type: 'vec3', when: 'lens' },
  { name: 'focus', type: 'float', when: 'lens' },
  { name: 'lensY', type: 'vec3', when: 'lens' },
  { name: 'sequence', type: 'uint', when: 'path' },
  { name: 'index', type: 'uint', when: 'path' },
] as const;

/** Which sample is drawn, and of which random numbers. */
export interface SampleNumber {
  readonly sample: number;
  readonly seed: number;
}

/** `scale`: the scene's in its frame, for what has a length. */
export function packEye(
  view: CameraFrame,
  scale: number,
  { sample, seed }: SampleNumber,
): RecordValues<typeof eyeRecord> {
  const { corner, stepX, stepY, orthographic, lens = [NOWHERE, NOWHERE] } = view;
  const window = orthographic ? scale : 1;
  return {
    corner: times(corner, window),
    width: view.width,
    stepX: times(stepX, window),
    height: view.height,
    stepY: times(stepY, window),
    forward: view.forward,
    lensX: times(lens[0], scale),
    focus: view.focus * scale,
    lensY: times(lens[1], scale),
    sequence: sequenceSeed(sample, seed),
    index: sample >>> 1,
  };
}

/** Radiance from all around is mean + y slope, y being the height of the unit direction. */
export const surroundingsRecord = [
  { name: 'background', type: 'vec3', when: 'backgroundColor' },
  { name: 'mean', type: 'vec3', when: 'environment' },
  { name: 'slope', type: 'vec3', when: 'gradient' },
  { name: 'around', type: 'vec4', when: 'nested' },
] as const;

/** `around`: the numbers in the shader of the objects around the camera, the innermost first. */
export function packSurroundings(
  { background, environment }: ResolvedScene,
  around: readonly number[],
): RecordValues<typeof surroundingsRecord> {
  const { top, bottom } = environment ?? { top: BLACK, bottom: BLACK };
  return {
    background: typeof background === 'string' ? BLACK : background,
    mean: times(add(top, bottom), 0.5),
    slope: times(subtract(top, bottom), 0.5),
    around: [...around, -1, -1, -1, -1].slice(0, 4),
  };
}

const BLACK = [0, 0, 0] as const;
const NOWHERE: Vec3 = [0, 0, 0];
