/** Twin of shaders/shape/disc.glsl. */
import { planeAxes } from '../../primitives/plane.ts';
import type { Shape } from '../../schema.ts';
import { addScaled, dot, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

/** Distance t > 0 along the ray to the disc, or MISS. A ray that leaves the disc never meets it again. */
export function discDistance(shape: Shape<'disc'>, { origin, direction }: Ray, own: boolean): number {
  const { normal } = planeAxes(shape);
  const c = subtract(shape.center, origin);
  const t = dot(normal, c) / dot(normal, direction);
  const q = addScaled(c, direction, -t);
  return t > 0 && dot(q, q) <= shape.radius * shape.radius && !own ? t : MISS;
}

export const discNormal = (shape: Shape<'disc'>): Vec3 => planeAxes(shape).normal;

/** Lengths along the tangent and along normal × tangent, from the centre. */
export function discLengths(shape: Shape<'disc'>, point: Vec3): readonly [number, number] {
  const { tangent, bitangent } = planeAxes(shape);
  const fromCenter = subtract(point, shape.center);
  return [dot(tangent, fromCenter), dot(bitangent, fromCenter)];
}
