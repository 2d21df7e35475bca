/** Twin of shaders/shape/sphere.glsl. */
import type { Shape } from '../../schema.ts';
import { addScaled, dot, length, scale, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

/** Distance t > 0 along the ray to the nearest point of the sphere, or MISS. */
export function sphereDistance({ center, radius }: Shape<'sphere'>, { origin, direction }: Ray, own: boolean): number {
  const c = subtract(center, origin);
  const a = dot(direction, direction);
  const b = dot(c, direction);
  const power = (length(c) - radius) * (length(c) + radius);
  const aside = addScaled(c, direction, -b / a);
  const discriminant = b * b < a * radius * radius ? b * b - a * power : a * (radius * radius - dot(aside, aside));
  if (discriminant < 0) return MISS;
  const q = b + (b < 0 ? -Math.sqrt(discriminant) : Math.sqrt(discriminant));
  // The roots are power / q and q / a. The first is the ray's own where it starts on the surface.
  const t = own ? q / a : power > 0 ? power / q : Math.max(q / a, power / q);
  return t > 0 ? t : MISS;
}

/** The outward unit normal at a point of the sphere. */
export const sphereNormal = ({ center, radius }: Shape<'sphere'>, point: Vec3): Vec3 =>
  scale(subtract(point, center), 1 / radius);

/** Arc lengths from the meridian through +z towards +x, and from the pole at +y downwards. */
export function sphereLengths({ center, radius }: Shape<'sphere'>, point: Vec3): readonly [number, number] {
  const [x, y, z] = subtract(point, center);
  return [radius * Math.atan2(x, z), radius * Math.atan2(Math.hypot(x, z), y)];
}
