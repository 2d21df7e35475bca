/** Rays that graze a torus by as much as rounding: whether they meet it there is anybody's guess, but where they meet is not. */
import type { Vec3 } from '@ray-scene/core';
import { torus } from '../../packages/core/src/primitives/torus-shape.ts';
import { add, addScaled, cross, length, normalize, scale } from '../../packages/core/src/vector.ts';

export interface GrazingRay {
  readonly shape: {
    readonly type: 'torus';
    readonly center: Vec3;
    readonly axis: Vec3;
    readonly radius: number;
    readonly tube: number;
  };
  readonly origin: Vec3;
  readonly direction: Vec3;
}

/**
 * A ray that starts within 8 roundings of the torus, or up to its radius before or behind such a place, and is tangent to it
 * there. `rounding` is half an ulp of 1 of the numbers that those who are asked calculate with.
 */
export function grazingRay(random: () => number, rounding: number): GrazingRay {
  const signed = (): number => 2 * random() - 1;
  const size = 10 ** (8 * random());
  const radius = Math.fround(size * (1 + random()));
  const tube = Math.fround(radius * (0.05 + 0.9 * random()));
  const center = rounded(scale(anyDirection(signed), 4 * radius * random()));
  const axis = rounded(anyDirection(signed));
  const outwards = normalize(cross(axis, anyDirection(signed)));
  const angle = Math.PI * signed();
  const normal = add(scale(outwards, Math.cos(angle)), scale(normalize(axis), Math.sin(angle)));
  const place = addScaled(addScaled(center, outwards, radius), normal, tube);
  const tangent = normalize(cross(normal, anyDirection(signed)));
  const beside = addScaled(place, normal, 8 * rounding * radius * signed());
  const along = random() < 0.3 ? 0 : radius * 10 ** (-6 * random()) * signed();
  const origin = addScaled(beside, tangent, along);
  const inF32 = rounding > 2 ** -53;
  return {
    shape: { type: 'torus', center, axis, radius, tube },
    origin: inF32 ? rounded(origin) : origin,
    direction: inF32 ? rounded(tangent) : tangent,
  };
}

/** How far off the torus the point is at the distance t, in roundings of the torus's reach; 0 for a miss. */
export function offTorus({ shape, origin, direction }: GrazingRay, t: number, rounding: number): number {
  if (!Number.isFinite(t)) return 0;
  return torus.clearance(shape, addScaled(origin, direction, t)) / (rounding * (shape.radius + shape.tube));
}

const rounded = ([x, y, z]: Vec3): Vec3 => [Math.fround(x), Math.fround(y), Math.fround(z)];

function anyDirection(signed: () => number): Vec3 {
  const v: Vec3 = [signed(), signed(), signed()];
  const far = length(v);
  return far > 0.1 && far < 1 ? scale(v, 1 / far) : anyDirection(signed);
}
