/** What the shader is told of the eye and of what surrounds the scene. */
import type { CameraFrame } from './camera-frame.ts';
import { powerOfTwoBelow } from './frame.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { RecordValues } from './std140.ts';
import { add, length, rounded, subtract, scale as times, type Vec3 } from './vector.ts';

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

/** Which sample is drawn, and of which random numbers. */
export interface SampleNumber {
  readonly sample: number;
  readonly seed: number;
  /** Radiance above which samples are dimmed. */
  readonly clamp?: number | undefined;
}

type Halves = readonly [high: Vec3, low: Vec3];

/** What the vectors are multiplied by: where rays all start at one point, their length does not matter. */
export const eyeUnit = ({ corner }: CameraFrame): number => 0.125 / powerOfTwoBelow(length(corner));

/**
 * In f32, a ray towards the horizon loses the digits of its slope, the small difference of a corner and many steps. With
 * `exact`, vectors are split: pixel centres are halves and first parts are multiples of 2^-22, so all sums are multiples of
 * 2^-23; they are below 2, up to which f32 holds those, since the corner is shorter than 1/4, and the window's sides are
 * not longer than twice the way to it.
 */
export function packEye(frame: CameraFrame, exact: boolean): RecordValues<typeof eyeRecord> {
  const [corner, stepX, stepY] = [frame.corner, frame.stepX, frame.stepY].map((v) => {
    const whole = times(v, eyeUnit(frame));
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
  { name: 'around', type: 'vec4', when: 'nested' },
] as const;

/** `around`: the numbers in the shader of the objects around the camera, the innermost first. */
export function packSurroundings(
  { background, environment }: ResolvedScene,
  around: readonly number[],
): RecordValues<typeof surroundingsRecord> {
  // An image is among the emitters.
  const { top, bottom } = environment && environment.kind !== 'image' ? environment : { top: BLACK, bottom: BLACK };
  return {
    background: typeof background === 'string' ? BLACK : background,
    mean: times(add(top, bottom), 0.5),
    slope: times(subtract(top, bottom), 0.5),
    around: [...around, -1, -1, -1, -1].slice(0, 4),
  };
}

const BLACK = [0, 0, 0] as const;
