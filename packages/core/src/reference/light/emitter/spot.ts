/** Twin of shaders/light/emitter/spot.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { negate, scale, type Vec3 } from '../../../vector.ts';
import { pointSample } from './point.ts';
import { profileAlong } from './profile.ts';
import type { EmitterSample } from './sample.ts';

export function spotSample(light: EmitterOf<'spot'>, p: Vec3): EmitterSample | undefined {
  const sample = pointSample(light, p);
  return (
    sample && { ...sample, radiance: scale(sample.radiance, profileAlong(light.profile, negate(sample.direction))) }
  );
}
