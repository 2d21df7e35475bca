/** Twin of shaders/light/emitter/sphere.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { add, addScaled, dot, length, negate, scale, subtract, type Vec3 } from '../../../vector.ts';
import { coneDirection, conePdf } from './cone.ts';
import { aroundDirection, insidePdf, insideSample } from './inside.ts';
import { profileAlong } from './profile.ts';
import type { EmitterSample } from './sample.ts';

export function sphereSample(
  sphere: EmitterOf<'sphere'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  const c = subtract(sphere.center, p);
  const { away, power } = sphereFrom(sphere, c);
  if (own) return acrossSample(sphere, scale(c, 1 / away), u);
  if (power <= 0) {
    const direction = aroundDirection(u);
    return insideSample(sphere, direction, sphereExit(sphere, c, power, direction));
  }
  const direction = coneDirection(scale(c, 1 / away), sphereCone(sphere, away, power), u);
  const along = dot(c, direction);
  const aside = addScaled(c, direction, -along);
  const halfChord = Math.sqrt(Math.max(sphere.radius * sphere.radius - dot(aside, aside), 0));
  return {
    direction,
    distance: power / (along + halfChord),
    radiance: scale(sphereRadiance(sphere, direction), sphere.side === 'back' ? 0 : 1),
    pdf: conePdf(sphereCone(sphere, away, power)),
    delta: false,
    object: sphere.object,
  };
}

export function spherePdf(sphere: EmitterOf<'sphere'>, from: Vec3, direction: Vec3, own: boolean): number {
  const c = subtract(sphere.center, from);
  const { away, power } = sphereFrom(sphere, c);
  if (own) return sphere.side === 'front' ? 0 : Math.max(dot(c, direction), 0) / (Math.PI * away);
  return power <= 0 ? insidePdf(sphere) : conePdf(sphereCone(sphere, away, power));
}

/** The radiance along -direction. */
export const sphereRadiance = ({ radiance, profile }: EmitterOf<'sphere'>, direction: Vec3): Vec3 =>
  profile ? scale(radiance, profileAlong(profile, negate(direction))) : radiance;

/** How far the centre is, and the power of the point: that squared less the radius squared. */
function sphereFrom({ radius }: EmitterOf<'sphere'>, c: Vec3): { readonly away: number; readonly power: number } {
  const away = length(c);
  return { away, power: (away - radius) * (away + radius) };
}

/** 1 - cos of the half-angle under which the sphere is seen from outside: sin² / (1 + cos), which does not cancel. */
function sphereCone({ radius }: EmitterOf<'sphere'>, away: number, power: number): number {
  const sine = radius / away;
  return (sine * sine) / (1 + Math.sqrt(power) / away);
}

/**
 * From a point on it, all points of a sphere are equally likely: that is in proportion to the cosine with the way to the
 * centre, `axis`, as a dull surface scatters light, which then is gathered without noise.
 */
function acrossSample(
  sphere: EmitterOf<'sphere'>,
  axis: Vec3,
  u: readonly [number, number],
): EmitterSample | undefined {
  const way = add(axis, aroundDirection(u));
  const size = length(way);
  return insideSample(sphere, scale(way, 1 / (size || 1)), sphere.radius * size, size / (2 * Math.PI));
}

/** How far the surface is from a point inside. */
function sphereExit({ radius }: EmitterOf<'sphere'>, c: Vec3, power: number, direction: Vec3): number {
  const along = dot(c, direction);
  const aside = addScaled(c, direction, -along);
  const root = Math.sqrt(Math.max(radius * radius - dot(aside, aside), 0));
  return along > 0 ? along + root : -power / (root - along);
}
