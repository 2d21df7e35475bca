/** What the shader of the integrator `path` is told of a material, besides what `material-record.ts` has. */
import { LARGEST_LENGTH } from './fields.ts';
import type { Frame } from './frame.ts';
import { imageMapRecord, packImageMap } from './image-map.ts';
import { ggxAlpha } from './material-record.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { Material } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { scale as times, type Vec3 } from './vector.ts';

export const pathMaterialRecord = [
  { name: 'alpha', type: 'float', when: 'path reflective' },
  { name: 'specular', type: 'vec3', when: 'transmission' },
  { name: 'transmission', type: 'float', when: 'transmission' },
  { name: 'attenuation', type: 'vec3', when: 'attenuation' },
  { name: 'ior', type: 'float', when: 'transmission' },
  { name: 'emission', type: 'vec3', when: 'emissive' },
  { name: 'emitter', type: 'int', when: 'emissive areaEmitter' },
  { name: 'shinesInFront', type: 'float', when: 'emissive' },
  { name: 'shinesBehind', type: 'float', when: 'emissive' },
  ...imageMapRecord,
] as const;

/** Per length, what light loses on its way through the inside, as a logarithm; a number even where all is lost. */
function attenuation({ attenuationColor, attenuationDistance }: Material): Vec3 {
  if (!attenuationDistance) return [0, 0, 0];
  return attenuationColor.map((c) => Math.min(-Math.log(c) / attenuationDistance, LARGEST_LENGTH)) as unknown as Vec3;
}

/** More than any way through a scene makes of light. Packed, it is cut to what f32 holds. */
const BLACKEST = 1e30;

/** Of the `index`-th material; `emitter`: its place among the emitters, -1 for none. */
export function packPathMaterial(
  scene: ResolvedScene,
  index: number,
  frame: Frame,
  emitter: number,
): RecordValues<typeof pathMaterialRecord> {
  const material = scene.materials[index] as Material;
  const { emissionSide } = material;
  return {
    alpha: ggxAlpha(material.roughness),
    specular: times(material.specularColor, material.specular),
    transmission: material.transmission,
    attenuation: attenuation(material).map((x) => Math.min(x / frame.scale, BLACKEST)),
    ior: material.ior,
    emission: times(material.emission, material.emissionIntensity),
    emitter,
    shinesInFront: emissionSide === 'back' ? 0 : 1,
    shinesBehind: emissionSide === 'front' ? 0 : 1,
    ...packImageMap(scene, index, frame),
  };
}
