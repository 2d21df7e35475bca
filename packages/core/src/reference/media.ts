/**
 * Twin of shaders/media.glsl: which closed objects a path is inside of, the one that it entered last first. That one is
 * the medium, whatever else is there.
 */
import type { ResolvedScene } from '../resolve-scene.ts';
import type { Material } from '../schema.ts';
import type { Vec3 } from '../vector.ts';

/** Numbers of objects. */
export type Media = readonly number[];

/** As many as the shader keeps in mind: who enters more forgets the outermost. */
export const MOST_MEDIA = 4;

export const startMedia = ({ around }: ResolvedScene): Media => around.slice(0, MOST_MEDIA);

export const enter = (media: Media, object: number): Media => [object, ...media].slice(0, MOST_MEDIA);

export function leave(media: Media, object: number): Media {
  const at = media.indexOf(object);
  return at < 0 ? media : media.filter((_, i) => i !== at);
}

const materialOf = ({ objects, materials }: ResolvedScene, object: number | undefined): Material | undefined =>
  object === undefined ? undefined : materials[objects[object]?.material ?? -1];

/** Index of refraction of the medium; 1 outside of everything. */
export const indexOf = (scene: ResolvedScene, media: Media): number => materialOf(scene, media[0])?.ior ?? 1;

/** What is left of light after a way through the medium. Source: Beer-Lambert, as in KHR_materials_volume. */
export function transmittance(scene: ResolvedScene, media: Media, distance: number): Vec3 {
  const { attenuationColor, attenuationDistance } = materialOf(scene, media[0]) ?? {};
  if (!attenuationColor || !attenuationDistance) return [1, 1, 1];
  return attenuationColor.map((channel) => channel ** (distance / attenuationDistance)) as unknown as Vec3;
}
