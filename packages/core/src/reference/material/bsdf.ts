/**
 * Twin of shaders/material/bsdf.glsl: how a material scatters light at one point. Directions have unit length and are in
 * the frame of the surface: z is the normal on the side of wo, wo goes to the eye, wi to where the light comes from.
 */
import { add, addScaled, dot, mix, negate, scale, type Vec3 } from '../../vector.ts';
import { circle } from '../circle.ts';
import { exactFresnel, refracted, refractedCosine2 } from './dielectric.ts';
import { schlickWeight } from './metallic-roughness.ts';
import { type Facet, ggx, smithOverCosine, visibleNormal } from './microfacet.ts';

/** A material at one point. */
export interface Bsdf {
  readonly color: Vec3;
  /** GGX alpha; 0 is a mirror. */
  readonly alpha: number;
  /** Reflectance of the dielectric layer straight on and at grazing angles, for Schlick's approximation. */
  readonly f0: Vec3;
  readonly f90: number;
  readonly metalness: number;
  /** Factor on the exact Fresnel reflectance. */
  readonly specular: Vec3;
  readonly transmission: number;
  /** Index of refraction behind the surface over that in front; of a thin wall, of what it is made of. */
  readonly eta: number;
  /** Whether the surface is a wall with the same on both sides. */
  readonly thin: boolean;
}

export interface BsdfSample {
  readonly wi: Vec3;
  /** f |cos| / pdf; 0 where the path ends. */
  readonly weight: Vec3;
  /** Per solid angle; 0 for a direction that no other could have been. */
  readonly pdf: number;
}

export interface BsdfValue {
  /** f |cos|, without what only mirrors do. */
  readonly value: Vec3;
  /** With which `bsdfSample` finds the direction, per solid angle. */
  readonly pdf: number;
}

const BLACK: Vec3 = [0, 0, 0];
const NOTHING: BsdfValue = { value: BLACK, pdf: 0 };

/** Draws wi. u is where on the lobe; `lobe` in [0, 1) tells which. */
export function bsdfSample(bsdf: Bsdf, wo: Vec3, u: readonly [number, number], lobe: number): BsdfSample {
  const diffuse = diffuseProbability(bsdf, wo[2]);
  if (lobe < diffuse) {
    const wi = cosineDirection(u);
    const { value, pdf } = bsdfValue(bsdf, wo, wi);
    return { wi, weight: scale(value, 1 / pdf), pdf };
  }
  const facet = bsdf.alpha > 0 ? visibleNormal(bsdf.alpha, wo, u) : flatFacet(wo);
  const split = splitAt(bsdf, facet.cosine);
  const isReflected = lobe - diffuse < split.reflection * (1 - diffuse);
  return isReflected
    ? sampleReflection(bsdf, wo, facet, split, diffuse)
    : sampleTransmission(bsdf, wo, facet, split, 1 - diffuse);
}

/** What light from wi gives in the direction wo, and with which density `bsdfSample` finds wi. */
export function bsdfValue(bsdf: Bsdf, wo: Vec3, wi: Vec3): BsdfValue {
  if (wi[2] > 0) {
    const half = halfway(bsdf, add(wo, wi));
    return reflection(bsdf, wo, wi, half, splitAt(bsdf, half.cosine), diffuseProbability(bsdf, wo[2]));
  }
  if (bsdf.alpha === 0 || wi[2] === 0 || bsdf.transmission === 0) return NOTHING;
  return bsdf.thin ? throughWall(bsdf, wo, wi) : refraction(bsdf, wo, wi);
}

/** Whether there is nothing that lights could be asked for. */
export const isMirrorOnly = (bsdf: Bsdf): boolean =>
  (bsdf.alpha === 0 || isGone(bsdf)) && (bsdf.metalness === 1 || bsdf.transmission === 1);

/** Whether the same is on both sides, and the surface is not there at all. */
const isGone = ({ eta, thin, transmission, metalness }: Bsdf): boolean =>
  eta === 1 && !thin && transmission > 0 && metalness === 0;

/** What becomes of light at a facet. */
interface Split {
  readonly reflected: Vec3;
  /** Goes on behind the surface. */
  readonly transmitted: Vec3;
  /** Is scattered below the surface and comes out of it again. */
  readonly diffuse: Vec3;
  /** Probability that a facet reflects rather than lets through. */
  readonly reflection: number;
}

/** Reflectance of the dielectric layer. Source: glTF 2.0, Appendix B, with KHR_materials_ior and KHR_materials_specular. */
function layerReflectance({ transmission, specular, eta, f0, f90 }: Bsdf, cosine: number): Vec3 {
  if (transmission > 0) return scale(specular, exactFresnel(cosine, eta));
  return mix(f0, [f90, f90, f90], schlickWeight(cosine));
}

/** At a facet whose normal makes the given cosine with wo. */
function splitAt(bsdf: Bsdf, cosine: number): Split {
  const { color, metalness, transmission, thin, eta } = bsdf;
  const layer = layerReflectance(bsdf, cosine);
  const reflected = mix(layer, mix(color, [1, 1, 1], schlickWeight(cosine)), metalness);
  const under = (1 - metalness) * (1 - Math.max(...layer));
  const hasWay = thin || refractedCosine2(cosine, eta) >= 0;
  const transmitted = scale(color, hasWay ? under * transmission : 0);
  const all = sum(reflected) + sum(transmitted);
  return {
    reflected,
    transmitted,
    diffuse: scale(color, under * (1 - transmission)),
    reflection: all > 0 ? sum(reflected) / all : 1,
  };
}

/**
 * Probability of drawing from the diffuse lobe: in proportion to the albedos of the lobes. What gets under the layer is
 * taken straight on, since light that is scattered diffusely meets facets that are turned towards it.
 */
function diffuseProbability(bsdf: Bsdf, cosine: number): number {
  const { color, metalness, transmission, f0 } = bsdf;
  const diffuse = (1 - metalness) * (1 - transmission) * (1 - Math.max(...f0)) * sum(color);
  const { reflected, transmitted } = splitAt(bsdf, cosine);
  return diffuse === 0 ? 0 : diffuse / (diffuse + sum(reflected) + sum(transmitted));
}

/** D and the cosine at the half vector h of any length. */
const halfway = ({ alpha }: Bsdf, h: Vec3): Omit<Facet, 'normal'> => ({
  cosine: 0.5 * Math.sqrt(dot(h, h)),
  density: alpha > 0 ? ggx(alpha, h) : 0,
});

/** Both lobes above the surface. */
function reflection(
  { alpha }: Bsdf,
  wo: Vec3,
  wi: Vec3,
  { density }: Pick<Facet, 'density'>,
  split: Split,
  diffuse: number,
): BsdfValue {
  const even = wi[2] / Math.PI;
  if (density === 0) return { value: scale(split.diffuse, even), pdf: diffuse * even };
  const lobe = 0.25 * density * smithOverCosine(alpha, wo[2]);
  const shadowed = lobe * wi[2] * smithOverCosine(alpha, wi[2]);
  return {
    value: addScaled(scale(split.diffuse, even), split.reflected, shadowed),
    pdf: diffuse * even + (1 - diffuse) * split.reflection * lobe,
  };
}

/** The lobe below a thin wall: that of reflection, turned over. */
function throughWall(bsdf: Bsdf, wo: Vec3, [x, y, z]: Vec3): BsdfValue {
  const { cosine, density } = halfway(bsdf, add(wo, [x, y, -z]));
  const { transmitted, reflection: reflected } = splitAt(bsdf, cosine);
  const lobe = 0.25 * density * smithOverCosine(bsdf.alpha, wo[2]);
  return {
    value: scale(transmitted, -z * smithOverCosine(bsdf.alpha, -z) * lobe),
    pdf: (1 - diffuseProbability(bsdf, wo[2])) * (1 - reflected) * lobe,
  };
}

/**
 * The lobe below a rough surface, equations 16, 17 and 21 of Walter et al. 2007. With the half vector h = wo + eta wi not
 * normalised and the products taken from wo + wi, nothing cancels where eta is near 1.
 */
function refraction(bsdf: Bsdf, wo: Vec3, wi: Vec3): BsdfValue {
  const { alpha, eta } = bsdf;
  const both = add(wo, wi);
  const side = eta > 1 ? -1 : 1;
  const h = scale(addScaled(both, wi, eta - 1), side);
  const half2 = 0.5 * dot(both, both);
  const woH = side * (1 - eta + eta * half2);
  const wiH = side * (eta - 1 + half2);
  if (eta === 1 || !(h[2] > 0 && woH > 0 && wiH < 0)) return NOTHING;
  const length2 = dot(h, h);
  const { transmitted, reflection: reflected } = splitAt(bsdf, Math.min(woH / Math.sqrt(length2), 1));
  const lobe = ggx(alpha, h) * smithOverCosine(alpha, wo[2]) * (woH / length2) * (-wiH / length2);
  return {
    value: scale(transmitted, -wi[2] * smithOverCosine(alpha, -wi[2]) * lobe),
    pdf: (1 - diffuseProbability(bsdf, wo[2])) * (1 - reflected) * eta * eta * lobe,
  };
}

function sampleReflection(bsdf: Bsdf, wo: Vec3, facet: Facet, split: Split, diffuse: number): BsdfSample {
  const { normal, cosine } = facet;
  const wi = addScaled(negate(wo), normal, 2 * cosine);
  if (bsdf.alpha === 0) {
    return { wi, weight: scale(split.reflected, 1 / ((1 - diffuse) * split.reflection)), pdf: 0 };
  }
  if (!(wi[2] > 0)) return { wi, weight: BLACK, pdf: 0 };
  // By the facet that was drawn: of a narrow lobe the rounded directions do not tell it.
  const { value, pdf } = reflection(bsdf, wo, wi, facet, split, diffuse);
  return { wi, weight: scale(value, 1 / pdf), pdf };
}

/** `chosen` is the probability that it was not the diffuse lobe. */
function sampleTransmission(bsdf: Bsdf, wo: Vec3, facet: Facet, split: Split, chosen: number): BsdfSample {
  const { alpha, eta, thin } = bsdf;
  const probability = chosen * (1 - split.reflection);
  if (probability === 0) return { wi: negate(wo), weight: BLACK, pdf: 0 };
  const weight = scale(split.transmitted, 1 / (thin ? probability : probability * eta * eta));
  // With the same on both sides there is nothing that could bend it, nor anything rough.
  if (eta === 1 && !thin) return { wi: negate(wo), weight, pdf: 0 };
  const wi = thin ? mirroredBelow(wo, facet) : refracted(wo, facet.normal, facet.cosine, eta);
  if (alpha === 0) return { wi, weight, pdf: 0 };
  if (!(wi[2] < 0)) return { wi, weight: BLACK, pdf: 0 };
  const visible = facet.density * smithOverCosine(alpha, wo[2]);
  return {
    wi,
    weight: scale(weight, -wi[2] * smithOverCosine(alpha, -wi[2])),
    pdf: probability * visible * (thin ? 0.25 : facet.cosine * refractedDensity(facet.cosine, eta)),
  };
}

/** Solid angle of facets over that of the directions that they refract to: equation 17 of Walter et al. 2007. */
function refractedDensity(cosine: number, eta: number): number {
  const behind = Math.sqrt(refractedCosine2(cosine, eta));
  const difference = ((eta - 1) * (eta + 1)) / (cosine + behind);
  return (eta * behind) / (difference * difference);
}

function mirroredBelow(wo: Vec3, { normal, cosine }: Facet): Vec3 {
  const [x, y, z] = addScaled(negate(wo), normal, 2 * cosine);
  return [x, y, -z];
}

/** The facet of a mirror. */
const flatFacet = (wo: Vec3): Facet => ({ normal: [0, 0, 1], cosine: wo[2], density: 0 });

/** A direction whose probability density is its cosine over pi. */
function cosineDirection([angle, area]: readonly [number, number]): Vec3 {
  const [x, y] = circle(angle);
  const radius = Math.sqrt(area);
  return [radius * x, radius * y, Math.sqrt(1 - area)];
}

const sum = ([r, g, b]: Vec3): number => r + g + b;
