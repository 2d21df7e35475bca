import { toFrame } from '../frame.ts';
import { add, length, scale, subtract, type Vec3 } from '../vector.ts';
import { boxTable } from './box.ts';
import { lowWord } from './flat.ts';
import type { Bounds } from './primitive.ts';
import { definePrimitive } from './primitive.ts';

const NOWHERE = [1e30, 1e30, 1e30] as const;

export const box = definePrimitive({
  ...boxTable,
  record: [
    { name: 'low', type: 'vec3' },
    { name: 'high', type: 'vec3' },
    { name: 'low2', type: 'vec3', when: 'wideRange' },
    { name: 'high2', type: 'vec3', when: 'wideRange' },
    { name: 'perCell', type: 'float', when: 'boxChecker' },
  ],
  pack(shape, frame, { checkerSize }) {
    const { min, max } = boxCorners(shape);
    const [low, high] = [toFrame(frame, min), toFrame(frame, max)];
    return { low, high, low2: lowWord(low), high2: lowWord(high), perCell: 1 / (checkerSize * frame.scale) };
  },
  // Beyond any distance that a ray gets to.
  absent: { low: NOWHERE, high: NOWHERE, low2: [0, 0, 0], high2: [0, 0, 0], perCell: 0 },
  closed: true,
  bounds: (shape) => boxCorners(shape),
  extent(shape, frame) {
    const { min, max } = boxCorners(shape);
    return Math.max(length(toFrame(frame, min)), length(toFrame(frame, max)));
  },
  size: ({ size }) => Math.min(...size),
  clearance: (shape, point) => Math.abs(outside(shape, point)),
  side: (shape, point) => (outside(shape, point) < 0 ? -1 : 1),
  farSide: () => 1,
  occludes: (side) => side > 0,
});

/** Its lowest and highest corner. */
export function boxCorners({ center, size }: { readonly center: Vec3; readonly size: Vec3 }): Bounds {
  const half = scale(size, 0.5);
  return { min: subtract(center, half), max: add(center, half) };
}

/** How far a point is outside of the nearest face, along an axis; below 0 inside. */
const outside = ({ center, size }: { readonly center: Vec3; readonly size: Vec3 }, point: Vec3): number =>
  Math.max(...point.map((x, i) => Math.abs(x - (center[i] as number)) - (size[i] as number) / 2));
