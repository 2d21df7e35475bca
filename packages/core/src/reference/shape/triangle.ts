/** Twin of shaders/shape/triangle.glsl. */
import { triangleNormal } from '../../primitives/triangle-shape.ts';
import type { Shape } from '../../schema.ts';
import { cross, dot, normalize, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

export { triangleNormal };

/** Two vectors across a ray. The products of a corner with them are its place in the plane that the ray is longest across, sheared. */
interface TriangleRay {
  readonly first: Vec3;
  readonly second: Vec3;
}

function triangleRay([dx, dy, dz]: Vec3): TriangleRay {
  const [x, y, z] = [Math.abs(dx), Math.abs(dy), Math.abs(dz)];
  if (x > Math.max(y, z)) return { first: [-dy / dx, 1, 0], second: [-dz / dx, 0, 1] };
  if (y > z) return { first: [0, -dz / dy, 1], second: [1, -dx / dy, 0] };
  return { first: [1, 0, -dx / dz], second: [0, 1, -dy / dz] };
}

const triangleSheared = ({ first, second }: TriangleRay, corner: Vec3): readonly [number, number] => [
  dot(first, corner),
  dot(second, corner),
];

/** Distance t > 0 along the ray to the triangle, or MISS. A ray that leaves the triangle never meets it again. */
export function triangleDistance(shape: Shape<'triangle'>, { origin, direction }: Ray, own: boolean): number {
  const ray = triangleRay(direction);
  const p = triangleSheared(ray, subtract(shape.a, origin));
  const q = triangleSheared(ray, subtract(shape.b, origin));
  const r = triangleSheared(ray, subtract(shape.c, origin));
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
