/** Twin of shaders/light/emitter/sun.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { dot, subtract, type Vec3 } from '../../../vector.ts';
import { coneDirection, conePdf } from './cone.ts';
import type { EmitterSample } from './sample.ts';

export const sunSample = (sun: EmitterOf<'sun'>, _p: Vec3, u: readonly [number, number]): EmitterSample => ({
  direction: coneDirection(sun.toLight, sun.cone, u),
  distance: Number.POSITIVE_INFINITY,
  radiance: sun.radiance,
  pdf: conePdf(sun.cone),
  delta: false,
});

/** 0 for directions that do not lead to it. */
export function sunPdf({ toLight, cone }: EmitterOf<'sun'>, direction: Vec3): number {
  const aside = subtract(direction, toLight);
  // Of unit vectors, the square of their difference is 2 (1 - cos).
  return dot(aside, aside) <= 2 * cone ? conePdf(cone) : 0;
}
