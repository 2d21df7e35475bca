/** What the shader of the integrator `path` is told of the eye, besides what `view-record.ts` has. */
import type { CameraFrame } from './camera-frame.ts';
import { reverseBits, sequenceSeed } from './random.ts';
import type { RecordValues } from './std140.ts';
import { scale as times, type Vec3 } from './vector.ts';
import { eyeUnit, type SampleNumber } from './view-record.ts';

export const pathEyeRecord = [
  { name: 'forward', type: 'vec3', when: 'ORTHOGRAPHIC' },
  { name: 'lensX', type: 'vec3', when: 'LENS' },
  { name: 'focus', type: 'float', when: 'LENS' },
  { name: 'lensY', type: 'vec3', when: 'LENS' },
  { name: 'toFocus', type: 'float', when: 'DEPTH' },
  { name: 'sequence', type: 'uint' },
  { name: 'reversed', type: 'uint' },
] as const;

const NOWHERE: Vec3 = [0, 0, 0];

/** `scale`: the scene's in its frame. */
export function packPathEye(
  view: CameraFrame,
  scale: number,
  { sample, seed }: SampleNumber,
): RecordValues<typeof pathEyeRecord> {
  const { forward, focus, lens = [NOWHERE, NOWHERE] } = view;
  return {
    forward,
    lensX: times(lens[0], scale),
    focus: (focus * scale) / eyeUnit(view, scale),
    lensY: times(lens[1], scale),
    toFocus: focus * scale,
    sequence: sequenceSeed(sample, seed),
    reversed: reverseBits(sample >>> 1),
  };
}
