/** Twin of shaders/light/environment.glsl. */
import type { ResolvedEnvironment } from '../../resolve-scene.ts';
import { mix, type Vec3 } from '../../vector.ts';

/** Radiance from a direction; none from an image, which is among the emitters. */
export const environmentRadiance = (environment: ResolvedEnvironment, direction: Vec3): Vec3 =>
  atHeight(environment, direction[1]);

/**
 * Irradiance over π on a surface with this normal that sees half of the environment: the integral of
 * (mean + slope y) cos / π over the hemisphere is mean + ⅔ slope y of the normal.
 */
export const environmentIrradiance = (environment: ResolvedEnvironment, normal: Vec3): Vec3 =>
  atHeight(environment, (2 / 3) * normal[1]);

const atHeight = (environment: ResolvedEnvironment, y: number): Vec3 =>
  environment.kind === 'image' ? [0, 0, 0] : mix(environment.bottom, environment.top, (1 + y) / 2);
