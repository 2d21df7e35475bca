/** What the shader is told of the eye and of what surrounds the scene. */
import type { CameraFrame } from './camera-frame.ts';
import { powerOfTwoBelow } from './frame.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { rounded } from './split-parts.ts';
import type { RecordValues } from './std140.ts';
import { add, length, scale, subtract, type Vec3 } from './vector.ts';

/** Rays through the window; see `CameraFrame` and `packEye`. Width and height are the window's, in pixels. */
export const eyeRecord = [
  { name: 'corner', type: 'vec3' },
  { name: 'width', type: 'float', when: 'VARYINGS' },
  { name: 'stepX', type: 'vec3' },
  { name: 'height', type: 'float', when: 'VARYINGS' },
  { name: 'stepY', type: 'vec3' },
  { name: 'corner2', type: 'vec3', when: 'EXACT_RAYS' },
  { name: 'stepX2', type: 'vec3', when: 'EXACT_RAYS' },
  { name: 'stepY2', type: 'vec3', when: 'EXACT_RAYS' },
] as const;

type Halves = readonly [high: Vec3, low: Vec3];

/**
 * In f32, a ray towards the horizon loses the digits of its slope, the small difference of a corner and many steps. With
 * `exact`, vectors are split: pixel centres are halves and first parts are multiples of 2^-22, so all sums are multiples of
 * 2^-23; they are below 2, up to which f32 holds those, since the corner is shorter than 1/4, and the window's sides are
 * not longer than twice the way to it.
 */
export function packEye(frame: CameraFrame, exact: boolean): RecordValues<typeof eyeRecord> {
  const unit = 0.125 / powerOfTwoBelow(length(frame.corner));
  const [corner, stepX, stepY] = [frame.corner, frame.stepX, frame.stepY].map((v) => {
    const whole = scale(v, unit);
    const high = exact ? rounded(whole, 22) : whole;
    return [high, subtract(whole, high)];
  }) as unknown as readonly [Halves, Halves, Halves];
  return {
    ...frame,
    corner: corner[0],
    corner2: corner[1],
    stepX: stepX[0],
    stepX2: stepX[1],
    stepY: stepY[0],
    stepY2: stepY[1],
  };
}

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
