/**
 * Twin of shaders/material/fresnel.glsl: what becomes of light at a facet of a material. Source: glTF 2.0, its definition
 * by `mix` (Appendix B of the specification), with KHR_materials_ior, _specular and _transmission.
 */
import { mix, scale, type Vec3 } from '../../vector.ts';
import { exactFresnel, refractedCosine2 } from './dielectric.ts';
import { schlickWeight } from './metallic-roughness.ts';

/** A material at one point. */
export interface Bsdf {
  readonly color: Vec3;
  readonly metalness: number;
  /** GGX; 0 is a mirror. */
  readonly alpha: number;
  /** Reflectance of the dielectric layer straight on and at grazing angles, for Schlick's approximation. */
  readonly f0: Vec3;
  readonly f90: number;
  /** Index of refraction behind the surface over that in front; of a thin wall, of what it is made of. */
  readonly eta: number;
  readonly transmission: number;
  /** Factor on the exact Fresnel reflectance. */
  readonly specular: Vec3;
  /** Whether the surface is a wall with the same on both sides. */
  readonly thin: boolean;
}

/** What becomes of light at a facet. */
export interface Split {
  readonly reflected: Vec3;
  /** Is scattered below the surface and comes out of it again. */
  readonly diffuse: Vec3;
  /** Goes on behind the surface. */
  readonly transmitted: Vec3;
  /** Probability that a facet reflects rather than lets through. */
  readonly reflection: number;
}

/** Whether some light is scattered below the surface. */
export const hasBase = ({ metalness, transmission }: Bsdf): boolean => (1 - metalness) * (1 - transmission) > 0;

/** Reflectance of the dielectric layer. */
function layerReflectance({ transmission, specular, eta, f0, f90 }: Bsdf, cosine: number): Vec3 {
  if (transmission > 0) return scale(specular, exactFresnel(cosine, eta));
  return mix(f0, [f90, f90, f90], schlickWeight(cosine));
}

/** At a facet whose normal makes the given cosine with wo. */
export function splitAt(bsdf: Bsdf, cosine: number): Split {
  const { color, metalness, transmission, thin, eta } = bsdf;
  const layer = layerReflectance(bsdf, cosine);
  const reflected = mix(layer, mix(color, [1, 1, 1], schlickWeight(cosine)), metalness);
  const under = (1 - metalness) * (1 - Math.max(...layer));
  const hasWay = thin || refractedCosine2(cosine, eta) >= 0;
  const transmitted = scale(color, hasWay ? under * transmission : 0);
  const all = sum(reflected) + sum(transmitted);
  return {
    reflected,
    diffuse: scale(color, under * (1 - transmission)),
    transmitted,
    reflection: all > 0 ? sum(reflected) / all : 1,
  };
}

/**
 * What is scattered below the surface, from wi to wo. glTF has it lose by the half vector alone, and so gives back more
 * than arrives where the layer reflects much and facets turned to the light do not: inside of what is partly let through,
 * where total reflection keeps light, without bounds. There it loses by the angles of both directions too.
 */
export function diffuseBetween(bsdf: Bsdf, { diffuse }: Split, wo: Vec3, wi: Vec3): Vec3 {
  if (bsdf.transmission === 0) return diffuse;
  const [toEye, toLight] = [splitAt(bsdf, wo[2]).diffuse, splitAt(bsdf, wi[2]).diffuse];
  return diffuse.map((channel, k) => Math.min(channel, toEye[k] as number, toLight[k] as number)) as unknown as Vec3;
}

/**
 * Probability of not drawing from the diffuse lobe, which is drawn from in proportion to the albedos of the lobes. What
 * gets under an opaque layer is taken straight on there, since light that is scattered diffusely meets facets that are
 * turned towards it.
 */
export function facetProbability(bsdf: Bsdf, cosine: number): number {
  const { color, metalness, transmission, f0 } = bsdf;
  const split = splitAt(bsdf, cosine);
  const straight = (1 - metalness) * (1 - Math.max(...f0)) * sum(color);
  const diffuse = transmission > 0 ? sum(split.diffuse) : straight;
  const facets = sum(split.reflected) + sum(split.transmitted);
  return diffuse > 0 ? facets / (diffuse + facets) : 1;
}

const sum = ([r, g, b]: Vec3): number => r + g + b;
