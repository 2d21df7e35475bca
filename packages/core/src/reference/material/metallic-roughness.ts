/** Twin of shaders/material/metallic-roughness.glsl. */
import { dielectricReflectance, ggxAlpha } from '../../material-record.ts';
import type { Material } from '../../schema.ts';
import { add, addScaled, cross, dot, mix, scale, type Vec3 } from '../../vector.ts';
import type { Surface } from '../surface.ts';

/** (1 - cos)⁵, the weight of Schlick's approximation; cos in [0, 1]. */
export const schlickWeight = (cosine: number): number => Math.max(0, 1 - cosine) ** 5;

/** Fresnel reflectance of the dielectric layer. */
export function dielectricFresnel(material: Material, weight: number): Vec3 {
  const { f0, f90 } = dielectricReflectance(material);
  return mix(f0, [f90, f90, f90], weight);
}

/** Fresnel reflectance of the whole material: of its dielectric and its metal part, by metalness. */
export function fresnel({ material, color }: Surface, weight: number): Vec3 {
  const metal = mix(color, [1, 1, 1], weight);
  return mix(dielectricFresnel(material, weight), metal, material.metalness);
}

/** Albedo of the diffuse part: what the dielectric layer lets through. */
export function diffuseAlbedo({ material, color }: Surface, weight: number): Vec3 {
  const reflected = Math.max(...dielectricFresnel(material, weight));
  return scale(color, (1 - material.metalness) * (1 - reflected));
}

/**
 * D V of GGX, with the separable Smith term, for a normal n and unit directions v and l on its side.
 * h = l + v is not normalised, and 1 - (n·h)² is |n × h|²: nothing cancels, however narrow the lobe.
 */
export function ggxLobe(alpha: number, n: Vec3, v: Vec3, l: Vec3): number {
  if (alpha === 0) return 0;
  const h = add(l, v);
  const across = cross(n, h);
  const along = dot(n, h);
  const x = (alpha * dot(h, h)) / (dot(across, across) + alpha * alpha * along * along);
  return (x * x) / (Math.PI * smith(alpha, dot(n, l)) * smith(alpha, dot(n, v)));
}

/** cos + √(alpha² + (1 - alpha²) cos²): 2 cos / G1 of Smith. */
const smith = (alpha: number, cosine: number): number =>
  cosine + Math.sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);

/** BRDF times the cosine of the light, for unit directions to the eye and to the light; nl > 0. */
export function scattered(surface: Surface, v: Vec3, l: Vec3): Vec3 {
  const { normal, material } = surface;
  const h = add(l, v);
  const weight = schlickWeight(0.5 * Math.sqrt(dot(h, h)));
  const diffuse = scale(diffuseAlbedo(surface, weight), 1 / Math.PI);
  const lobe = ggxLobe(ggxAlpha(material.roughness), normal, v, l);
  return scale(addScaled(diffuse, fresnel(surface, weight), lobe), dot(normal, l));
}
