/** What the shader is told of a material: the numbers that it computes with, worked out once in f64. */

import { LARGEST_LENGTH } from './fields.ts';
import type { Material } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { subtract, scale as times, type Vec3 } from './vector.ts';

export const materialRecord = [
  { name: 'color', type: 'vec3' },
  { name: 'alpha2', type: 'float', when: 'highlights' },
  { name: 'f0', type: 'vec3', when: 'specularTint' },
  { name: 'f0', type: 'float', when: 'specular !specularTint' },
  { name: 'f90', type: 'float', when: 'specularWeight' },
  { name: 'metalness', type: 'float', when: 'metal dielectric' },
  { name: 'checkerStep', type: 'vec3', when: 'checker' },
  { name: 'alpha', type: 'float', when: 'path reflective' },
  { name: 'specular', type: 'vec3', when: 'transmission' },
  { name: 'transmission', type: 'float', when: 'transmission' },
  { name: 'attenuation', type: 'vec3', when: 'attenuation' },
  { name: 'ior', type: 'float', when: 'transmission' },
  { name: 'emission', type: 'vec3', when: 'emissive' },
  { name: 'emitter', type: 'int', when: 'emissive' },
  { name: 'shinesInFront', type: 'float', when: 'emissive' },
  { name: 'shinesBehind', type: 'float', when: 'emissive' },
] as const;

/** A lobe that is narrower than the angle between two directions in f32 is packed as a mirror's, which has none. */
const SMALLEST_ALPHA = 2 ** -32;

/** GGX alpha of a roughness. */
export function ggxAlpha(roughness: number): number {
  const alpha = roughness * roughness;
  return alpha < SMALLEST_ALPHA ? 0 : alpha;
}

/**
 * Reflectance of the dielectric layer straight on and at grazing angles, for Schlick's approximation between them.
 * Source: glTF 2.0, Appendix B, and KHR_materials_ior, KHR_materials_specular.
 */
export function dielectricReflectance({ ior, specular, specularColor }: Material): { f0: Vec3; f90: number } {
  const straight = ((ior - 1) / (ior + 1)) ** 2;
  const tinted = specularColor.map((tint) => Math.min(straight * tint, 1)) as unknown as Vec3;
  return { f0: times(tinted, specular), f90: specular };
}

/** Per length, what light loses on its way through the inside, as a logarithm; a number even where all is lost. */
function attenuation({ attenuationColor, attenuationDistance }: Material): Vec3 {
  if (!attenuationDistance) return [0, 0, 0];
  return attenuationColor.map((c) => Math.min(-Math.log(c) / attenuationDistance, LARGEST_LENGTH)) as unknown as Vec3;
}

/** More than any way through a scene makes of light. Packed, it is cut to what f32 holds. */
const BLACKEST = 1e30;

/** `scale`: the scene's in its frame; `emitter`: its place among the emitters, -1 for none. */
export function packMaterial(material: Material, scale: number, emitter: number): RecordValues<typeof materialRecord> {
  const { f0, f90 } = dielectricReflectance(material);
  const { emissionSide } = material;
  return {
    color: material.color,
    alpha2: ggxAlpha(material.roughness) ** 2,
    f0,
    f90,
    metalness: material.metalness,
    checkerStep: material.checker ? subtract(material.checker, material.color) : [0, 0, 0],
    alpha: ggxAlpha(material.roughness),
    specular: times(material.specularColor, material.specular),
    transmission: material.transmission,
    attenuation: attenuation(material).map((x) => Math.min(x / scale, BLACKEST)),
    ior: material.ior,
    emission: times(material.emission, material.emissionIntensity),
    emitter,
    shinesInFront: emissionSide === 'back' ? 0 : 1,
    shinesBehind: emissionSide === 'front' ? 0 : 1,
  };
}
