/** Twin of shaders/light/emitter/point.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { length, scale, subtract, type Vec3 } from '../../../vector.ts';
import type { EmitterSample } from './sample.ts';

export function pointSample(
  { position, intensity, decay }: Pick<EmitterOf<'point'>, 'position' | 'intensity' | 'decay'>,
  p: Vec3,
): EmitterSample | undefined {
  const way = subtract(position, p);
  const distance = length(way);
  if (distance === 0) return undefined;
  return {
    direction: scale(way, 1 / distance),
    distance,
    radiance: scale(intensity, decay === 2 ? 1 / (distance * distance) : 1),
    pdf: 1,
    delta: true,
  };
}
