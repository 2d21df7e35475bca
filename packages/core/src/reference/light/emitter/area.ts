/** Twin of shaders/light/emitter/area.glsl: points of a surface, all equally likely, as directions. */
import type { EmitterOf } from '../../../emitters.ts';
import { length, scale, type Vec3 } from '../../../vector.ts';
import type { EmitterSample } from './sample.ts';

type Shining = Pick<EmitterOf<'disc'>, 'radiance' | 'side' | 'object'>;

/** Whether the side shines that faces the point. */
export const shines = ({ side }: Shining, front: boolean): boolean => side === 'both' || (side === 'front') === front;

/**
 * The light from the end of `way`. `height`: how far the point is from the plane of the surface there; it is on the front
 * of it, or not; `area`: of all the surface that might have been chosen.
 */
export function areaSample(
  emitter: Shining,
  way: Vec3,
  height: number,
  area: number,
  front: boolean,
): EmitterSample | undefined {
  const distance = length(way);
  if (!(height > 0 && distance > 0)) return undefined;
  return {
    direction: scale(way, 1 / distance),
    distance,
    radiance: scale(emitter.radiance, shines(emitter, front) ? 1 : 0),
    pdf: distance ** 3 / (height * area),
    delta: false,
    object: emitter.object,
  };
}

/** The pdf of a direction that meets the surface at a distance, under an angle of this cosine with its normal. */
export const areaPdf = (t: number, cosine: number, area: number): number =>
  cosine === 0 ? 0 : (t * t) / (Math.abs(cosine) * area);
