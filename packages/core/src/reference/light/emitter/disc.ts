/** Twin of shaders/light/emitter/disc.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { add, addScaled, dot, normalize, scale, subtract, type Vec3 } from '../../../vector.ts';
import { circle } from '../../circle.ts';
import { tangents } from '../../tangents.ts';
import { areaPdf, areaSample } from './area.ts';
import type { EmitterSample } from './sample.ts';

export function discSample(
  disc: EmitterOf<'disc'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  if (own) return undefined;
  const normal = normalize(disc.normal);
  const c = subtract(disc.center, p);
  const height = dot(normal, c);
  const [x, y] = tangents(normal);
  const [cosine, sine] = circle(u[1]);
  const out = disc.radius * Math.sqrt(u[0]);
  const way = add(c, addScaled(scale(x, out * cosine), y, out * sine));
  return areaSample(disc, way, Math.abs(height), area(disc), height < 0);
}

export const discPdf = (disc: EmitterOf<'disc'>, t: number, cosine: number): number => areaPdf(t, cosine, area(disc));

const area = ({ radius }: EmitterOf<'disc'>): number => Math.PI * radius * radius;
