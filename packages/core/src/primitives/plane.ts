import { vector } from '../fields.ts';
import { toFrame } from '../frame.ts';
import { cross, dot, length, normalize, scale, subtract, type Vec3 } from '../vector.ts';
import { definePrimitive } from './primitive.ts';

/** For most scenes; see `any-plane.ts` for the others. */
export const plane = definePrimitive({
  doc: 'A plane without end. U runs along the tangent, V along normal × tangent, both from the point.',
  fields: {
    point: vector('A point on it.', { default: [0, 0, 0] }),
    normal: vector('The direction it faces.', { default: [0, 1, 0], nonzero: true }),
    tangent: vector('The direction of U; default: the x axis, or z where the normal is nearly x.', { nonzero: true }),
  },
  record: [
    { name: 'downY', type: 'float', when: '!tiltedPlane' },
    { name: 'height', type: 'float' },
    { name: 'perCell', type: 'float', when: 'planeChecker !turnedChecker' },
    { name: 'startU', type: 'float', when: 'planeChecker' },
    { name: 'startV', type: 'float', when: 'planeChecker' },
  ],
  pack(shape, frame, { side, checkerSize }) {
    const { normal, tangent, bitangent } = planeAxes(shape);
    const point = toFrame(frame, shape.point);
    const cell = checkerSize * frame.scale;
    return {
      // Away from the camera: all light that reaches it leaves the plane on its side.
      downY: -side * normal[1],
      // Of the camera.
      height: -side * dot(normal, point),
      // U and V counted in cells; at the camera within the first pair of them, so that the numbers stay small.
      perCell: 1 / cell,
      startU: withinPair(-dot(tangent, point) / cell),
      startV: withinPair(-dot(bitangent, point) / cell),
    };
  },
  closed: false,
  bounds: () => undefined,
  extent: (shape, frame) => length(toFrame(frame, shape.point)),
  size: () => Number.POSITIVE_INFINITY,
  // A level plane needs no more than f32 however near it is.
  clearance(shape, point) {
    const { normal } = planeAxes(shape);
    const height = Math.abs(dot(normal, subtract(point, shape.point)));
    return height > 0 && Math.abs(normal[1]) === 1 ? Number.POSITIVE_INFINITY : height;
  },
  side: (shape, point) => (dot(planeAxes(shape).normal, subtract(point, shape.point)) < 0 ? -1 : 1),
  farSide: (shape, direction) => Math.sign(dot(planeAxes(shape).normal, direction)) as 1 | 0 | -1,
  occludes: () => false,
});

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

/** At the camera within the first pair of cells, so that the numbers stay small. */
export const withinPair = (cells: number): number => cells - 2 * Math.round(cells / 2);
