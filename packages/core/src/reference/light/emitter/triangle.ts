/** Twin of shaders/light/emitter/triangle.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { triangleNormal } from '../../../primitives/triangle-shape.ts';
import { addScaled, cross, dot, length, subtract, type Vec3 } from '../../../vector.ts';
import { areaPdf, areaSample } from './area.ts';
import type { EmitterSample } from './sample.ts';

export function triangleSample(
  triangle: EmitterOf<'triangle'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  if (own) return undefined;
  const { a, b, c } = triangle;
  const toA = subtract(a, p);
  const height = dot(triangleNormal(triangle), toA);
  // Towards the side across from a by the root of u, since the triangle widens that way.
  const root = Math.sqrt(u[0]);
  const way = addScaled(addScaled(toA, subtract(b, a), root * (1 - u[1])), subtract(c, a), root * u[1]);
  return areaSample(triangle, way, Math.abs(height), area(triangle), height < 0);
}

export const trianglePdf = (triangle: EmitterOf<'triangle'>, t: number, cosine: number): number =>
  areaPdf(t, cosine, area(triangle));

const area = ({ a, b, c }: EmitterOf<'triangle'>): number => length(cross(subtract(b, a), subtract(c, a))) / 2;
