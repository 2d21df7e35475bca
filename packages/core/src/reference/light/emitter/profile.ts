/** Twin of shaders/light/emitter/profile.glsl. */
import type { Profile } from '../../../emitters.ts';
import { cross, dot, length, type Vec3 } from '../../../vector.ts';

/** How much of a spotlight's light goes in a direction, between 0 and 1. */
export function profileAlong({ axis, outer, penumbra }: Profile, direction: Vec3): number {
  const angle = Math.atan2(length(cross(axis, direction)), dot(axis, direction));
  if (penumbra === 0) return angle < outer ? 1 : 0;
  return Math.min(Math.max((outer - angle) / (outer * penumbra), 0), 1);
}
