/** Twin of shaders/background.glsl. */
import type { ResolvedScene } from '../resolve-scene.ts';
import type { Vec3 } from '../vector.ts';
import { environmentRadiance } from './light/environment.ts';

/** Linear radiance, premultiplied by the coverage in alpha. */
export type Rgba = readonly [number, number, number, number];

/** What a camera ray shows that meets nothing. */
export function background({ background: shown, environment }: ResolvedScene, direction: Vec3): Rgba {
  if (shown === 'transparent') return [0, 0, 0, 0];
  if (shown !== 'environment') return [...shown, 1];
  return environment ? [...environmentRadiance(environment, direction), 1] : [0, 0, 0, 1];
}
