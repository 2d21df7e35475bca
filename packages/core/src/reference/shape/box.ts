/** Twin of shaders/shape/box.glsl. */
import { boxCorners } from '../../primitives/box-shape.ts';
import type { Shape } from '../../schema.ts';
import { subtract, type Vec3 } from '../../vector.ts';
import type { Ray } from '../ray.ts';
import { ALWAYS, bothOf, convexDistance, type Interval, NEVER } from './convex.ts';

/** Distance t > 0 along the ray to the nearest face, or MISS. */
export function boxDistance(shape: Shape<'box'>, { origin, direction }: Ray, own: boolean): number {
  const { min, max } = boxCorners(shape);
  const [low, high] = [subtract(min, origin), subtract(max, origin)];
  const slabs = direction.map((d, i) => boxSlab(low[i] as number, high[i] as number, d));
  return convexDistance(slabs.reduce(bothOf), own);
}

/** Along a slab, the line is inside always or never; on its face it is. */
function boxSlab(low: number, high: number, d: number): Interval {
  if (d === 0) return low <= 0 && high >= 0 ? ALWAYS : NEVER;
  return d > 0 ? [low / d, high / d] : [high / d, low / d];
}

/** The axis of the face that a point is on, and the face's side of it. */
function boxFace(shape: Shape<'box'>, point: Vec3): readonly [axis: number, side: number] {
  const { min, max } = boxCorners(shape);
  const [low, high] = [subtract(min, point), subtract(point, max)];
  const outside = low.map((x, i) => Math.max(x, high[i] as number));
  const axis = outside.indexOf(Math.max(...outside));
  return [axis, (low[axis] as number) > (high[axis] as number) ? -1 : 1];
}

/** The outward unit normal at a point of the box. */
export function boxNormal(shape: Shape<'box'>, point: Vec3): Vec3 {
  const [axis, side] = boxFace(shape, point);
  return [axis === 0 ? side : 0, axis === 1 ? side : 0, axis === 2 ? side : 0];
}

/** Lengths from the lowest corner: (z, y) on the x faces, (x, z) on the y faces, (x, y) on the z faces. */
export function boxLengths(shape: Shape<'box'>, point: Vec3): readonly [number, number] {
  const [x, y, z] = subtract(point, boxCorners(shape).min);
  const [axis] = boxFace(shape, point);
  if (axis === 0) return [z, y];
  return axis === 1 ? [x, z] : [x, y];
}
