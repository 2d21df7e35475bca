/** Twin of shaders/light/emitter/own-space.glsl: shapes that shine in a space of their own, as they are in the scene. */
import type { Affine } from '../../../affine.ts';
import { length, scale, type Vec3 } from '../../../vector.ts';
import type { EmitterSample } from './sample.ts';

/** What a sample of the own space is in the scene. A cone of the solid angle w has the volume w s³ / 3, s its length. */
export function sampleFromOwnSpace(place: Affine, sample: EmitterSample): EmitterSample {
  const way = place.direction(sample.direction);
  const size = length(way);
  return {
    ...sample,
    direction: scale(way, 1 / size),
    distance: sample.distance * size,
    pdf: sample.pdf * (size / place.meanFactor) ** 3,
  };
}

/** A ray that met an emitter, in the emitter's own space; a pdf there is divided by `density`. */
export function rayInOwnSpace(
  place: Affine,
  from: Vec3,
  d: Vec3,
  t: number,
): { readonly from: Vec3; readonly d: Vec3; readonly t: number; readonly density: number } {
  const way = place.directionBack(d);
  const size = length(way);
  return {
    from: place.pointBack(from),
    d: scale(way, 1 / size),
    t: t * size,
    density: (size * place.meanFactor) ** 3,
  };
}
