import { vector } from '../fields.ts';
import { toFrame } from '../frame.ts';
import { cross, dot, normalize, scale, subtract, type Vec3 } from '../vector.ts';
import { definePrimitive } from './primitive.ts';

export const plane = definePrimitive({
  doc: 'A plane without end. U runs along the tangent, V along normal × tangent, both from the point.',
  fields: {
    point: vector('A point on it.', { default: [0, 0, 0] }),
    normal: vector('The direction it faces.', { default: [0, 1, 0], nonzero: true }),
    tangent: vector('The direction of U; default: the x axis, or z where the normal is nearly x.', { nonzero: true }),
  },
  record: [
    { name: 'normal', type: 'vec3' },
    { name: 'offset', type: 'float' },
    { name: 'tangent', type: 'vec3', when: 'planeChecker' },
    { name: 'originU', type: 'float', when: 'planeChecker' },
    { name: 'bitangent', type: 'vec3', when: 'planeChecker' },
    { name: 'originV', type: 'float', when: 'planeChecker' },
    { name: 'material', type: 'int' },
  ],
  pack(shape, frame, checkerSize) {
    const { normal, tangent, bitangent } = planeAxes(shape);
    const point = toFrame(frame, shape.point);
    const period = 2 * checkerSize * frame.scale;
    return {
      normal,
      offset: dot(normal, point),
      tangent,
      bitangent,
      // The pattern repeats: the corner of a cell pair near the camera serves as well as one far away.
      originU: withinPeriod(dot(tangent, point), period),
      originV: withinPeriod(dot(bitangent, point), period),
      material: 0,
    };
  },
  bounds: () => undefined,
  extent: (shape, frame) => Math.abs(dot(planeAxes(shape).normal, toFrame(frame, shape.point))),
  shadowsItself: 'never',
});

const withinPeriod = (x: number, period: number): number => (period > 0 ? x - period * Math.round(x / period) : 0);

/** The unit normal and the directions of U and V in the plane, in f64. */
export function planeAxes(shape: { readonly normal: Vec3; readonly tangent?: Vec3 }): {
  readonly normal: Vec3;
  readonly tangent: Vec3;
  readonly bitangent: Vec3;
} {
  const normal = normalize(shape.normal);
  const along = shape.tangent ?? (Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 0, 1]);
  const tangent = normalize(subtract(along, scale(normal, dot(normal, along))));
  return { normal, tangent, bitangent: cross(normal, tangent) };
}
