import { toFrame } from '../frame.ts';
import { scale } from '../vector.ts';
import { lowWord, packNormal } from './flat.ts';
import { plane, planeAxes } from './plane.ts';
import { definePrimitive } from './primitive.ts';

const record = [
  { name: 'down', type: 'vec3', when: 'tiltedPlane' },
  ...plane.record,
  { name: 'cameraSide', type: 'float', when: 'sides' },
  { name: 'down2', type: 'vec3', when: 'tiltedPlane wideRange' },
  { name: 'down3', type: 'vec3', when: 'tiltedPlane wideRange' },
  { name: 'point', type: 'vec3', when: 'tiltedPlane' },
  { name: 'pointLow', type: 'vec3', when: 'tiltedPlane wideRange' },
  { name: 'cellU', type: 'vec3', when: 'planeChecker turnedChecker' },
  { name: 'cellV', type: 'vec3', when: 'planeChecker turnedChecker' },
] as const;

/** Stands in for `plane` where it may be turned. */
export const anyPlane = definePrimitive<typeof plane.fields, typeof record>({
  ...plane,
  record,
  absent: undefined,
  pack(shape, frame, context) {
    const { normal, tangent, bitangent } = planeAxes(shape);
    const point = toFrame(frame, shape.point);
    const cell = context.checkerSize * frame.scale;
    const down = packNormal(scale(normal, -context.side), context.wideRange);
    return {
      ...plane.pack(shape, frame, context),
      // Away from the camera: all light that reaches it leaves the plane on its side.
      down: down.normal,
      down2: down.normal2,
      down3: down.normal3,
      point,
      pointLow: lowWord(point),
      cameraSide: context.side,
      cellU: scale(tangent, 1 / cell),
      cellV: scale(bitangent, 1 / cell),
    };
  },
});
