import { powerOfTwoBelow, toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { addScaled, dot, length, scale, subtract, type Vec3 } from '../vector.ts';
import { coneTable } from './cone.ts';
import { perpendicular, roundAxes, roundBounds } from './cylinder-shape.ts';
import { lowWord, packNormal } from './flat.ts';
import { definePrimitive } from './primitive.ts';

const ZERO = [0, 0, 0] as const;

export const cone = definePrimitive({
  ...coneTable,
  record: [
    { name: 'tip', type: 'vec3' },
    { name: 'slope', type: 'float' },
    { name: 'axis', type: 'vec3' },
    { name: 'height', type: 'float' },
    { name: 'p', type: 'vec3' },
    { name: 'hv', type: 'float' },
    { name: 'base', type: 'vec3' },
    { name: 'c', type: 'float' },
    { name: 'toBase', type: 'float' },
    { name: 'tipLow', type: 'vec3', when: 'wideRange' },
    { name: 'baseLow', type: 'vec3', when: 'wideRange' },
    { name: 'axis2', type: 'vec3', when: 'wideRange' },
    { name: 'axis3', type: 'vec3', when: 'wideRange' },
    { name: 'gradient1', type: 'vec3', when: 'wideRange' },
    { name: 'gradient2', type: 'vec3', when: 'wideRange' },
    { name: 'gradient3', type: 'vec3', when: 'wideRange' },
    { name: 'gradientScale', type: 'float', when: 'wideRange' },
    { name: 'cellU', type: 'vec3', when: 'coneChecker' },
    { name: 'cellV', type: 'vec3', when: 'coneChecker' },
    { name: 'cellsAlong', type: 'float', when: 'coneChecker' },
  ],
  pack(shape, frame, { checkerSize, wideRange }) {
    const { axis, tangent, bitangent } = coneAxes(shape);
    const [tip, base] = [toFrame(frame, shape.tip), toFrame(frame, shape.base)];
    const height = length(subtract(base, tip));
    const slope = (shape.radius * frame.scale) / height;
    const hv = dot(axis, tip);
    const p = perpendicular(tip, axis);
    const across = slope * Math.abs(hv);
    const parts = packNormal(axis, wideRange);
    const gradient = addScaled(p, axis, -slope * slope * hv);
    // A power of two that makes its length less than 1.
    const gradientScale = 2 * powerOfTwoBelow(length(gradient) || 1);
    const [gradient1, gradient2, gradient3] = splitParts(scale(gradient, 1 / gradientScale));
    const cell = checkerSize * frame.scale;
    return {
      tip,
      slope,
      axis: parts.normal,
      height,
      p,
      hv,
      c: (length(p) - across) * (length(p) + across),
      base,
      toBase: dot(axis, base),
      tipLow: lowWord(tip),
      baseLow: lowWord(base),
      axis2: parts.normal2,
      axis3: parts.normal3,
      gradient1,
      gradient2,
      gradient3,
      gradientScale,
      cellU: scale(tangent, 1 / cell),
      cellV: scale(bitangent, 1 / cell),
      cellsAlong: 1 / cell,
    };
  },
  // A base before the tip leaves nothing.
  absent: {
    tip: ZERO,
    slope: 0,
    axis: [0, 1, 0],
    height: -1,
    p: ZERO,
    hv: 0,
    c: 1,
    base: ZERO,
    toBase: -1,
    tipLow: ZERO,
    baseLow: ZERO,
    axis2: ZERO,
    axis3: ZERO,
    gradient1: ZERO,
    gradient2: ZERO,
    gradient3: ZERO,
    gradientScale: 0,
    cellU: ZERO,
    cellV: ZERO,
    cellsAlong: 0,
  },
  closed: true,
  bounds: ({ base, tip, radius }) => roundBounds(base, tip, radius, 0),
  extent: ({ base, tip, radius }, frame) =>
    Math.max(length(toFrame(frame, base)), length(toFrame(frame, tip)), radius * frame.scale),
  size: ({ base, tip, radius }) => Math.min(radius, length(subtract(tip, base))),
  clearance: (shape, point) => Math.abs(outside(shape, point)),
  side: (shape, point) => (outside(shape, point) < 0 ? -1 : 1),
  farSide: () => 1,
  occludes: (side) => side > 0,
});

/** The unit vector from the tip to the base, and where U and V begin around it. */
export function coneAxes({ base, tip }: { readonly base: Vec3; readonly tip: Vec3 }) {
  const { axis, tangent, bitangent } = roundAxes(base, tip);
  return { axis: scale(axis, -1), tangent, bitangent };
}

/** How far a point is outside of the nearest part of the surface; below 0 inside. */
function outside(shape: { base: Vec3; tip: Vec3; radius: number }, point: Vec3): number {
  const { axis } = coneAxes(shape);
  const slope = shape.radius / length(subtract(shape.base, shape.tip));
  const fromTip = subtract(point, shape.tip);
  const beyond = length(perpendicular(fromTip, axis)) - slope * dot(axis, fromTip);
  return Math.max(beyond / Math.sqrt(1 + slope * slope), dot(axis, subtract(point, shape.base)));
}
