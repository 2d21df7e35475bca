/** Twin of shaders/shape/plane.glsl. */
import { planeAxes } from '../../primitives/plane.ts';
import type { Shape } from '../../schema.ts';
import { dot, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

/** Distance t > 0 along the ray to the plane, or MISS. A ray that leaves the plane never meets it again. */
export function planeDistance(shape: Shape<'plane'>, { origin, direction }: Ray, own: boolean): number {
  const { normal } = planeAxes(shape);
  const t = dot(normal, subtract(shape.point, origin)) / dot(normal, direction);
  return t > 0 && !own ? t : MISS;
}

export const planeNormal = (shape: Shape<'plane'>): Vec3 => planeAxes(shape).normal;

/** Lengths along the tangent and along normal × tangent, from the point. */
export function planeLengths(shape: Shape<'plane'>, point: Vec3): readonly [number, number] {
  const { tangent, bitangent } = planeAxes(shape);
  const fromPoint = subtract(point, shape.point);
  return [dot(tangent, fromPoint), dot(bitangent, fromPoint)];
}
