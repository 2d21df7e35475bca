/** What the shader of the integrator `direct` is told of lights: one record for each kind, and how it is packed. */
import { type Frame, toFrame } from './frame.ts';
import type { Light, LightKind } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { negate, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** The lights that it knows: those that cast hard shadows. */
export const directKinds = ['point', 'directional'] as const satisfies readonly LightKind[];
export type DirectKind = (typeof directKinds)[number];

type LightOf<K extends LightKind> = Extract<Light, { type: K }>;

const pointRecord = [
  { name: 'position', type: 'vec3' },
  { name: 'decays', type: 'float', when: 'mixedFalloff' },
  { name: 'intensity', type: 'vec3' },
] as const;

const directionalRecord = [
  { name: 'toLight', type: 'vec3' },
  { name: 'irradiance', type: 'vec3' },
] as const;

/** By kind: the name of the GLSL struct, its members, and their values for a light, over the π of every BRDF. */
export const lightRecords = {
  point: {
    struct: 'PointLight',
    record: pointRecord,
    pack: (
      { position, color, intensity, decay }: LightOf<'point'>,
      frame: Frame,
    ): RecordValues<typeof pointRecord> => ({
      position: toFrame(frame, position),
      decays: decay === 2 ? 1 : 0,
      // Distances are in units of the frame, so candelas are too.
      intensity: scale(color, (intensity * (decay === 2 ? frame.scale * frame.scale : 1)) / Math.PI),
    }),
  },
  directional: {
    struct: 'DirectionalLight',
    record: directionalRecord,
    pack: (light: LightOf<'directional'>): RecordValues<typeof directionalRecord> => ({
      toLight: directionToLight(light),
      irradiance: scale(light.color, light.intensity / Math.PI),
    }),
  },
} as const satisfies { [K in DirectKind]: unknown };

/** The record of a light of any kind. */
export const packLight = (light: LightOf<DirectKind>, frame: Frame) =>
  light.type === 'point' ? lightRecords.point.pack(light, frame) : lightRecords.directional.pack(light);

/** Unit vector from any point to a directional light. */
export function directionToLight(light: Omit<LightOf<'directional'>, 'angularDiameter'>): Vec3 {
  const { direction, position, target = [0, 0, 0] } = light;
  return normalize(direction ? negate(direction) : position ? subtract(position, target) : [0, 1, 0]);
}
