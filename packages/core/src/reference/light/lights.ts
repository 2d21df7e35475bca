/** Twin of shaders/light/lights.glsl: the light of point and directional lights that arrives at a point. */
import { directionToLight } from '../../light-records.ts';
import type { Light } from '../../schema.ts';
import { length, scale, subtract, type Vec3 } from '../../vector.ts';
import { MISS } from '../ray.ts';

export interface Arriving {
  /** Unit vector to the light. */
  readonly direction: Vec3;
  /** How far the light is; MISS for a directional one. */
  readonly distance: number;
  /** Irradiance on a surface that faces the light. */
  readonly irradiance: Vec3;
}

export function lightArriving(light: Light, position: Vec3): Arriving {
  if (light.type === 'directional') {
    return { direction: directionToLight(light), distance: MISS, irradiance: scale(light.color, light.intensity) };
  }
  const toLight = subtract(light.position, position);
  const distance = length(toLight);
  return {
    // At the light itself no side of a surface faces it.
    direction: scale(toLight, distance > 0 ? 1 / distance : 0),
    distance,
    irradiance: scale(light.color, light.intensity / (light.decay === 2 ? distance * distance : 1)),
  };
}
