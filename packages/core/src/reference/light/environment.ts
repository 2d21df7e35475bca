/** Twin of shaders/light/environment.glsl. */
import type { ResolvedEnvironment } from '../../resolve-scene.ts';
import { mix, type Vec3 } from '../../vector.ts';

/** Radiance from a direction. */
export const environmentRadiance = ({ top, bottom }: ResolvedEnvironment, direction: Vec3): Vec3 =>
  mix(bottom, top, (1 + direction[1]) / 2);

/**
 * Irradiance over π on a surface with this normal that sees half of the environment: the integral of
 * (mean + slope y) cos / π over the hemisphere is mean + ⅔ slope y of the normal.
 */
export const environmentIrradiance = ({ top, bottom }: ResolvedEnvironment, normal: Vec3): Vec3 =>
  mix(bottom, top, (1 + (2 / 3) * normal[1]) / 2);
