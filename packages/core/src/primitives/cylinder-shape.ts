import { toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { addScaled, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../vector.ts';
import { cylinderTable } from './cylinder.ts';
import { lowWord, packNormal } from './flat.ts';
import { planeAxes } from './plane.ts';
import { type Bounds, definePrimitive } from './primitive.ts';

const ZERO = [0, 0, 0] as const;

export const cylinder = definePrimitive({
  ...cylinderTable,
  record: [
    { name: 'base', type: 'vec3' },
    { name: 'radius', type: 'float' },
    { name: 'axis', type: 'vec3' },
    { name: 'height', type: 'float' },
    { name: 'p', type: 'vec3' },
    { name: 'k', type: 'float' },
    { name: 'toBase', type: 'float' },
    { name: 'toTop', type: 'float' },
    { name: 'baseLow', type: 'vec3', when: 'wideRange' },
    { name: 'axis2', type: 'vec3', when: 'wideRange' },
    { name: 'axis3', type: 'vec3', when: 'wideRange' },
    { name: 'half1', type: 'vec3', when: 'wideRange' },
    { name: 'half2', type: 'vec3', when: 'wideRange' },
    { name: 'half3', type: 'vec3', when: 'wideRange' },
    { name: 'cellU', type: 'vec3', when: 'cylinderChecker' },
    { name: 'cellsAround', type: 'float', when: 'cylinderChecker' },
    { name: 'cellV', type: 'vec3', when: 'cylinderChecker' },
    { name: 'cellsAlong', type: 'float', when: 'cylinderChecker' },
  ],
  pack(shape, frame, { checkerSize, wideRange }) {
    const { axis, tangent, bitangent } = roundAxes(shape.base, shape.top);
    const [base, top] = [toFrame(frame, shape.base), toFrame(frame, shape.top)];
    const radius = shape.radius * frame.scale;
    const p = perpendicular(base, axis);
    const parts = packNormal(axis, wideRange);
    const [half1, half2, half3] = splitParts(scale(p, 0.5));
    const cell = checkerSize * frame.scale;
    return {
      base,
      radius,
      axis: parts.normal,
      height: length(subtract(top, base)),
      p,
      k: (length(p) - radius) * (length(p) + radius),
      toBase: dot(axis, base),
      toTop: dot(axis, top),
      baseLow: lowWord(base),
      axis2: parts.normal2,
      axis3: parts.normal3,
      half1,
      half2,
      half3,
      cellU: scale(tangent, 1 / cell),
      cellsAround: shape.radius / checkerSize,
      cellV: scale(bitangent, 1 / cell),
      cellsAlong: 1 / cell,
    };
  },
  // Between caps in the wrong order there is nothing.
  absent: {
    base: ZERO,
    radius: 0,
    axis: [0, 1, 0],
    height: -1,
    p: ZERO,
    k: 1,
    toBase: 1,
    toTop: -1,
    baseLow: ZERO,
    axis2: ZERO,
    axis3: ZERO,
    half1: ZERO,
    half2: ZERO,
    half3: ZERO,
    cellU: ZERO,
    cellsAround: 0,
    cellV: ZERO,
    cellsAlong: 0,
  },
  closed: true,
  bounds: ({ base, top, radius }) => roundBounds(base, top, radius, radius),
  extent: ({ base, top, radius }, frame) =>
    Math.max(length(toFrame(frame, base)), length(toFrame(frame, top)), radius * frame.scale),
  size: ({ base, top, radius }) => Math.min(radius, length(subtract(top, base))),
  clearance: (shape, point) => Math.abs(outside(shape, point)),
  side: (shape, point) => (outside(shape, point) < 0 ? -1 : 1),
  farSide: () => 1,
  occludes: (side) => side > 0,
});

/** The unit vector along the axis, and where U and V begin around it. */
export function roundAxes(base: Vec3, top: Vec3): { axis: Vec3; tangent: Vec3; bitangent: Vec3 } {
  const { normal: axis, tangent, bitangent } = planeAxes({ normal: subtract(top, base) });
  return { axis, tangent, bitangent };
}

/** The part of a vector that is perpendicular to a unit axis. */
export const perpendicular = (v: Vec3, axis: Vec3): Vec3 => cross(axis, cross(v, axis));

/** The box around two discs perpendicular to the line between their middles. */
export function roundBounds(a: Vec3, b: Vec3, radiusA: number, radiusB: number): Bounds {
  const axis = normalize(subtract(b, a));
  const reach = axis.map((x) => Math.sqrt(Math.max(0, 1 - x * x))) as unknown as Vec3;
  const ends = [addScaled(a, reach, radiusA), addScaled(a, reach, -radiusA), addScaled(b, reach, radiusB)];
  const all = [...ends, addScaled(b, reach, -radiusB)];
  return {
    min: [0, 1, 2].map((i) => Math.min(...all.map((v) => v[i] as number))) as unknown as Vec3,
    max: [0, 1, 2].map((i) => Math.max(...all.map((v) => v[i] as number))) as unknown as Vec3,
  };
}

/** How far a point is outside of the nearest part of the surface; below 0 inside. */
function outside({ base, top, radius }: { base: Vec3; top: Vec3; radius: number }, point: Vec3): number {
  const { axis } = roundAxes(base, top);
  const across = length(perpendicular(subtract(point, base), axis)) - radius;
  return Math.max(across, dot(axis, subtract(base, point)), dot(axis, subtract(point, top)));
}
