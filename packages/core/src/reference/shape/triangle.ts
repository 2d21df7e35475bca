/** Twin of shaders/shape/triangle.glsl. */
import { triangleNormal } from '../../primitives/triangle-shape.ts';
import type { Shape } from '../../schema.ts';
import { cross, dot, normalize, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

export { triangleNormal };

/** The axes in turn, so that the one along which the direction is longest comes last. */
function longestLast([x, y, z]: Vec3, axis: number): Vec3 {
  if (axis === 0) return [y, z, x];
  return axis === 1 ? [z, x, y] : [x, y, z];
}

/** Distance t > 0 along the ray to the triangle, or MISS. A ray that leaves the triangle never meets it again. */
export function triangleDistance(shape: Shape<'triangle'>, { origin, direction }: Ray, own: boolean): number {
  const [x, y, z] = direction.map(Math.abs) as [number, number, number];
  const axis = x > Math.max(y, z) ? 0 : y > z ? 1 : 2;
  const d = longestLast(direction, axis);
  const sheared = (corner: Vec3): readonly [number, number] => {
    const c = longestLast(subtract(corner, origin), axis);
    return [c[0] - (d[0] / d[2]) * c[2], c[1] - (d[1] / d[2]) * c[2]];
  };
  const [p, q, r] = [sheared(shape.a), sheared(shape.b), sheared(shape.c)];
  const u = r[0] * q[1] - r[1] * q[0];
  const v = p[0] * r[1] - p[1] * r[0];
  const w = q[0] * p[1] - q[1] * p[0];
  if (!(Math.min(u, v, w) >= 0 || Math.max(u, v, w) <= 0)) return MISS;
  const normal = triangleNormal(shape);
  const t = dot(normal, subtract(shape.a, origin)) / dot(normal, direction);
  return t > 0 && t < MISS && !own ? t : MISS;
}

/** Lengths along the first edge and across it, from the first corner. */
export function triangleLengths(shape: Shape<'triangle'>, point: Vec3): readonly [number, number] {
  const u = normalize(subtract(shape.b, shape.a));
  const fromA = subtract(point, shape.a);
  return [dot(u, fromA), dot(cross(triangleNormal(shape), u), fromA)];
}
