/** Twin of shaders/light/emitter/directional.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import type { EmitterSample } from './sample.ts';

export const directionalSample = ({ toLight, irradiance }: EmitterOf<'directional'>): EmitterSample => ({
  direction: toLight,
  distance: Number.POSITIVE_INFINITY,
  radiance: irradiance,
  pdf: 1,
  delta: true,
});
