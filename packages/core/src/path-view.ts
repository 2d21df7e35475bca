/** What the shader of the integrator `path` is told of the eye, besides what `view-record.ts` has. */
import type { CameraFrame } from './camera-frame.ts';
import type { Frame } from './frame.ts';
import { pixelSample, reverseBits, sequenceSeed } from './random.ts';
import type { RecordValues } from './std140.ts';
import { dot, subtract, scale as times, type Vec3 } from './vector.ts';
import { eyeUnit, type SampleNumber } from './view-record.ts';

export const pathEyeRecord = [
  { name: 'forward', type: 'vec3', when: 'DISTANT' },
  { name: 'spread', type: 'float', when: 'DISTANT' },
  { name: 'toStart', type: 'float', when: 'DISTANT DEPTH' },
  { name: 'lensX', type: 'vec3', when: 'LENS' },
  { name: 'focus', type: 'float', when: 'LENS' },
  { name: 'lensY', type: 'vec3', when: 'LENS' },
  { name: 'toFocus', type: 'float', when: 'DEPTH' },
  { name: 'placeX', type: 'float', when: 'SHARED_PLACE' },
  { name: 'placeY', type: 'float', when: 'SHARED_PLACE' },
  { name: 'mostRadiance', type: 'float', when: 'CLAMP' },
  { name: 'sequence', type: 'uint' },
  { name: 'reversed', type: 'uint' },
] as const;

/** No limit; also a number in f32. */
const LARGEST = 1e30;

const NOWHERE: Vec3 = [0, 0, 0];

export function packPathEye(
  view: CameraFrame,
  { origin, scale }: Frame,
  { sample, seed, clamp = LARGEST }: SampleNumber,
): RecordValues<typeof pathEyeRecord> {
  const { forward, focus, lens = [NOWHERE, NOWHERE] } = view;
  const [placeX, placeY] = pixelSample(sample, seed);
  const toStart = dot(forward, subtract(origin, view.origin));
  return {
    ...((view.orthographic || toStart > 0) && windowAt(view, toStart, scale)),
    forward,
    spread: view.orthographic ? 0 : 1 / (toStart * scale),
    toStart: toStart * scale,
    lensX: times(lens[0], scale),
    focus: (focus * scale) / eyeUnit(view),
    lensY: times(lens[1], scale),
    toFocus: focus * scale,
    placeX,
    placeY,
    mostRadiance: Math.min(clamp, LARGEST),
    sequence: sequenceSeed(sample, seed),
    reversed: reverseBits(sample >>> 1),
  };
}

/** The window in the plane that is so far ahead, around its middle; instead of what `packEye` says. */
function windowAt({ orthographic, corner, forward, stepX, stepY }: CameraFrame, ahead: number, scale: number) {
  const unit = orthographic ? scale : ahead * scale;
  const fromMiddle = orthographic ? corner : subtract(corner, forward);
  return { corner: times(fromMiddle, unit), stepX: times(stepX, unit), stepY: times(stepY, unit) };
}
