/** What emitters of all kinds answer with; twin of the struct in shaders/light/emitters.glsl. */
import type { Vec3 } from '../../../vector.ts';

export interface EmitterSample {
  /** Unit vector to the light. */
  readonly direction: Vec3;
  /** How far the light is in that direction; Infinity: infinitely far. */
  readonly distance: number;
  /** Radiance from there if nothing is in the way; of a light without extent, irradiance on a surface that faces it. */
  readonly radiance: Vec3;
  /** Per solid angle, times the probability of the emitter; of a light without extent, that probability. */
  readonly pdf: number;
  /** Whether the light has no extent, so that no ray meets it by chance. */
  readonly delta: boolean;
  /** The object that shines, if it is one: it does not stand in its own way. */
  readonly object?: number;
}
