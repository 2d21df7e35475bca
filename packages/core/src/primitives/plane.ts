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
    { name: 'normal', type: 'vec3', when: 'tiltedPlane' },
    { name: 'facing', type: 'float', when: '!tiltedPlane' },
    { name: 'offset', type: 'float' },
    { name: 'cellU', type: 'vec3', when: 'planeChecker turnedChecker' },
    { name: 'perCell', type: 'float', when: 'planeChecker !turnedChecker' },
    { name: 'originU', type: 'float', when: 'planeChecker' },
    { name: 'cellV', type: 'vec3', when: 'planeChecker turnedChecker' },
    { name: 'originV', type: 'float', when: 'planeChecker' },
  ],
  pack(shape, frame, { side, checkerSize }) {
    const { normal, tangent, bitangent } = planeAxes(shape);
    const point = toFrame(frame, shape.point);
    const cell = checkerSize * frame.scale;
    return {
      // Towards the camera: all light that reaches it leaves the plane on its side.
      normal: scale(normal, side),
      facing: side * normal[1],
      offset: side * dot(normal, point),
      // U and V counted in cells, from the corner of a pair of cells near the camera rather than from far away.
      perCell: 1 / cell,
      cellU: scale(tangent, 1 / cell),
      originU: withinPair(dot(tangent, point) / cell),
      cellV: scale(bitangent, 1 / cell),
      originV: withinPair(dot(bitangent, point) / cell),
    };
  },
  // It faces nowhere.
  absent: {
    normal: [0, 0, 0],
    facing: 0,
    offset: 0,
    cellU: [0, 0, 0],
    perCell: 0,
    originU: 0,
    cellV: [0, 0, 0],
    originV: 0,
  },
  bounds: () => undefined,
  extent: (shape, frame) => Math.abs(dot(planeAxes(shape).normal, toFrame(frame, shape.point))),
  side: (shape, point) => (dot(planeAxes(shape).normal, subtract(point, shape.point)) < 0 ? -1 : 1),
  farSide: (shape, direction) => Math.sign(dot(planeAxes(shape).normal, direction)) as 1 | 0 | -1,
  occludes: () => false,
});

const withinPair = (cells: number): number => cells - 2 * Math.round(cells / 2);

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
