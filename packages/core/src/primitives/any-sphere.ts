import { toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { scale } from '../vector.ts';
import { lowWord } from './flat.ts';
import { definePrimitive } from './primitive.ts';
import { sphere } from './sphere.ts';

const record = [
  ...sphere.record,
  // Cells along one radian.
  { name: 'cells', type: 'float', when: 'sphereChecker' },
  // What f32 leaves of the centre.
  { name: 'centerLow', type: 'vec3', when: 'wideRange' },
  { name: 'half1', type: 'vec3', when: 'wideRange' },
  { name: 'half2', type: 'vec3', when: 'wideRange' },
  { name: 'half3', type: 'vec3', when: 'wideRange' },
] as const;

/** Stands in for `sphere` where it may be as large as a planet, or very far away. */
export const anySphere = definePrimitive<typeof sphere.fields, typeof record>({
  ...sphere,
  record,
  absent: undefined,
  pack(shape, frame, context) {
    const center = toFrame(frame, shape.center);
    // The frame has lengths below 2, and `splitParts` takes those up to 1.
    const [half1, half2, half3] = splitParts(scale(center, 0.5));
    return {
      ...sphere.pack(shape, frame, context),
      cells: shape.radius / context.checkerSize,
      centerLow: lowWord(center),
      half1,
      half2,
      half3,
    };
  },
});
