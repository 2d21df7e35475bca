/**
 * What the shader is told of a material: the numbers that it computes with, worked out once in f64. See `path-material.ts`
 * for what only paths ask.
 */
import type { Material } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { scale, subtract, type Vec3 } from './vector.ts';

export const materialRecord = [
  { name: 'color', type: 'vec3' },
  { name: 'alpha2', type: 'float', when: 'highlights' },
  { name: 'f0', type: 'vec3', when: 'specularTint' },
  { name: 'f0', type: 'float', when: 'specular !specularTint' },
  { name: 'f90', type: 'float', when: 'specularWeight' },
  { name: 'metalness', type: 'float', when: 'metal dielectric' },
  { name: 'checkerStep', type: 'vec3', when: 'checker' },
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
  return { f0: scale(tinted, specular), f90: specular };
}

export function packMaterial(material: Material): RecordValues<typeof materialRecord> {
  const { f0, f90 } = dielectricReflectance(material);
  return {
    color: material.color,
    alpha2: ggxAlpha(material.roughness) ** 2,
    f0,
    f90,
    metalness: material.metalness,
    checkerStep: material.checker ? subtract(material.checker, material.color) : [0, 0, 0],
  };
}
