/** Twin of shaders/light/emitter/quad.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { quadNormal } from '../../../primitives/quad-shape.ts';
import { addScaled, cross, dot, length, subtract, type Vec3 } from '../../../vector.ts';
import { areaPdf, areaSample } from './area.ts';
import { type Rectangle, rectangleAngle, rectanglePlace } from './rectangle.ts';
import type { EmitterSample } from './sample.ts';

/** By solid angle where that is large enough and the quad is a rectangle, else by area. */
export function quadSample(
  quad: EmitterOf<'quad'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  if (own) return undefined;
  const c = subtract(quad.corner, p);
  const height = dot(quadNormal(quad), c);
  const rectangle = seenFrom(quad, c, height);
  const angle = rectangleAngle(rectangle);
  const bySolidAngle = angle >= quad.leastAngle;
  const [v, w] = bySolidAngle ? rectanglePlace(rectangle, angle, u) : u;
  const way = addScaled(addScaled(c, quad.edgeU, v), quad.edgeV, w);
  const sample = areaSample(quad, way, Math.abs(height), area(quad), height < 0);
  return sample && (bySolidAngle ? { ...sample, pdf: 1 / angle } : sample);
}

export function quadPdf(quad: EmitterOf<'quad'>, from: Vec3, t: number, cosine: number): number {
  const c = subtract(quad.corner, from);
  const angle = rectangleAngle(seenFrom(quad, c, dot(quadNormal(quad), c)));
  return angle >= quad.leastAngle ? 1 / angle : areaPdf(t, cosine, area(quad));
}

const area = ({ edgeU, edgeV }: EmitterOf<'quad'>): number => length(cross(edgeU, edgeV));

/** In axes along the edges and the normal, around the point. */
function seenFrom({ edgeU, edgeV }: EmitterOf<'quad'>, c: Vec3, height: number): Rectangle {
  const [wide, tall] = [length(edgeU), length(edgeV)];
  const low = [dot(c, edgeU) / wide, dot(c, edgeV) / tall] as const;
  return { low, high: [low[0] + wide, low[1] + tall], height: Math.abs(height) };
}
