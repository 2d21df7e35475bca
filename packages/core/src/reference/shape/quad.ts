/** Twin of shaders/shape/quad.glsl. */
import { duals } from '../../primitives/flat.ts';
import { quadNormal } from '../../primitives/quad-shape.ts';
import type { Shape } from '../../schema.ts';
import { cross, dot, length, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

export { quadNormal };

/** Distance t > 0 along the ray to the quad, or MISS. A ray that leaves the quad never meets it again. */
export function quadDistance(
  { corner, edgeU, edgeV }: Shape<'quad'>,
  { origin, direction }: Ray,
  own: boolean,
): number {
  const c = subtract(corner, origin);
  const normal = cross(edgeU, edgeV);
  const approach = dot(normal, direction);
  const t = dot(normal, c) / approach;
  const facing = Math.sign(approach);
  const u = facing * dot(cross(edgeV, c), direction);
  const v = facing * dot(cross(c, edgeU), direction);
  const inside = Math.min(u, v, Math.abs(approach) - Math.max(u, v));
  return t > 0 && t < MISS && inside >= 0 && !own ? t : MISS;
}

/** Lengths along the edges, from the corner. */
export function quadLengths({ corner, edgeU, edgeV }: Shape<'quad'>, point: Vec3): readonly [number, number] {
  const fromCorner = subtract(point, corner);
  const [u, v] = duals(edgeU, edgeV);
  return [length(edgeU) * dot(u, fromCorner), length(edgeV) * dot(v, fromCorner)];
}
