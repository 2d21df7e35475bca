/**
 * Twin of shaders/material/bsdf.glsl: how a material scatters light at one point. Directions have unit length and are in
 * the frame of the surface: z is the normal on the side of wo, wo goes to the eye, wi to where the light comes from.
 */
import { add, addScaled, dot, length, negate, scale, type Vec3 } from '../../vector.ts';
import { circle } from '../circle.ts';
import { refracted, refractedCosine2 } from './dielectric.ts';
import { type Bsdf, diffuseBetween, facetProbability, hasBase, type Split, splitAt } from './fresnel.ts';
import { type Facet, ggx, smithOverCosine, visibleNormal } from './microfacet.ts';

export type { Bsdf };

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

/** A direction whose probability density is its cosine over pi. */
function cosineDirection([angle, area]: readonly [number, number]): Vec3 {
  const [x, y] = circle(angle);
  const radius = Math.sqrt(area);
  return [radius * x, radius * y, Math.sqrt(1 - area)];
}

/** Both lobes above the surface; `facets` is the probability of not drawing from the diffuse one, `density` is D. */
function reflection(bsdf: Bsdf, wo: Vec3, wi: Vec3, density: number, split: Split, facets: number): BsdfValue {
  const { alpha } = bsdf;
  const even = wi[2] / Math.PI;
  const diffuse = { value: scale(diffuseBetween(bsdf, split, wo, wi), even), pdf: even * (1 - facets) };
  if (density === 0) return diffuse;
  const lobe = 0.25 * density * smithOverCosine(alpha, wo[2]);
  return {
    value: addScaled(diffuse.value, split.reflected, lobe * wi[2] * smithOverCosine(alpha, wi[2])),
    pdf: diffuse.pdf + facets * split.reflection * lobe,
  };
}

/** The facet that mirrors wo to wi, told by their sum. */
function halfway({ alpha }: Bsdf, h: Vec3): Facet {
  const size = length(h);
  return { normal: scale(h, 1 / size), cosine: 0.5 * size, density: alpha > 0 ? ggx(alpha, h) : 0 };
}

/** A facet that is seen from wo. */
const facetSeen = ({ alpha }: Bsdf, wo: Vec3, u: readonly [number, number]): Facet =>
  alpha > 0 ? visibleNormal(alpha, wo, u) : { normal: [0, 0, 1], cosine: wo[2], density: 0 };

const mirrored = (wo: Vec3, { normal, cosine }: Facet): Vec3 => addScaled(negate(wo), normal, 2 * cosine);

/** The lobe below a thin wall: that of reflection, turned over. */
function throughWall(bsdf: Bsdf, wo: Vec3, [x, y, z]: Vec3): BsdfValue {
  const { cosine, density } = halfway(bsdf, add(wo, [x, y, -z]));
  const split = splitAt(bsdf, cosine);
  const lobe = 0.25 * density * smithOverCosine(bsdf.alpha, wo[2]);
  return {
    value: scale(split.transmitted, lobe * -z * smithOverCosine(bsdf.alpha, -z)),
    pdf: facetProbability(bsdf, wo[2]) * (1 - split.reflection) * lobe,
  };
}

/** `probability` is that of coming here. */
function sampleWall({ alpha }: Bsdf, wo: Vec3, facet: Facet, split: Split, probability: number): BsdfSample {
  const [x, y, z] = mirrored(wo, facet);
  const wi: Vec3 = [x, y, -z];
  const weight = scale(split.transmitted, 1 / probability);
  if (alpha === 0) return { wi, weight, pdf: 0 };
  if (!(z > 0)) return { wi, weight: BLACK, pdf: 0 };
  return {
    wi,
    weight: scale(weight, z * smithOverCosine(alpha, z)),
    pdf: probability * 0.25 * facet.density * smithOverCosine(alpha, wo[2]),
  };
}

/**
 * The lobe below a rough surface, equations 16, 17 and 21 of Walter et al. With the half vector h = wo + eta wi not
 * normalised and the products taken from wo + wi, nothing cancels where eta is near 1.
 */
function refraction(bsdf: Bsdf, wo: Vec3, wi: Vec3): BsdfValue {
  const { alpha, eta } = bsdf;
  const both = add(wo, wi);
  const side = eta > 1 ? -1 : 1;
  const h = scale(addScaled(both, wi, eta - 1), side);
  const half2 = 0.5 * dot(both, both);
  const woH = side * (1 - eta + eta * half2);
  const wiH = -side * (eta - 1 + half2);
  if (eta === 1 || !(h[2] > 0 && woH > 0 && wiH > 0)) return NOTHING;
  const length2 = dot(h, h);
  const split = splitAt(bsdf, Math.min(woH / Math.sqrt(length2), 1));
  const lobe = ggx(alpha, h) * smithOverCosine(alpha, wo[2]) * (woH / length2) * (wiH / length2);
  return {
    value: scale(split.transmitted, lobe * -wi[2] * smithOverCosine(alpha, -wi[2])),
    pdf: facetProbability(bsdf, wo[2]) * (1 - split.reflection) * eta * eta * lobe,
  };
}

/** Solid angle of facets over that of the directions that they refract to: equation 17 of Walter et al. */
function refractedDensity(cosine: number, eta: number): number {
  const behind = Math.sqrt(refractedCosine2(cosine, eta));
  const difference = ((eta - 1) * (eta + 1)) / (cosine + behind);
  return (eta * behind) / (difference * difference);
}

/** `probability` is that of coming here. */
function sampleRefraction(bsdf: Bsdf, wo: Vec3, facet: Facet, split: Split, probability: number): BsdfSample {
  const { alpha, eta } = bsdf;
  const weight = scale(split.transmitted, 1 / (probability * eta * eta));
  // With the same on both sides there is nothing that could bend it, nor anything rough.
  if (eta === 1) return { wi: negate(wo), weight, pdf: 0 };
  const wi = refracted(wo, facet.normal, facet.cosine, eta);
  if (alpha === 0) return { wi, weight, pdf: 0 };
  if (!(wi[2] < 0)) return { wi, weight: BLACK, pdf: 0 };
  const visible = facet.density * smithOverCosine(alpha, wo[2]) * facet.cosine;
  return {
    wi,
    weight: scale(weight, -wi[2] * smithOverCosine(alpha, -wi[2])),
    pdf: probability * visible * refractedDensity(facet.cosine, eta),
  };
}

/** Whether there is nothing that lights could be asked for. */
export const isMirrorOnly = (bsdf: Bsdf): boolean => bsdf.alpha === 0 && !hasBase(bsdf);

/** What light from wi gives in the direction wo, and with which density `bsdfSample` finds wi. */
export function bsdfValue(bsdf: Bsdf, wo: Vec3, wi: Vec3): BsdfValue {
  const { alpha, transmission, thin } = bsdf;
  if (wi[2] > 0) {
    const { cosine, density } = halfway(bsdf, add(wo, wi));
    return reflection(bsdf, wo, wi, density, splitAt(bsdf, cosine), facetProbability(bsdf, wo[2]));
  }
  if (alpha === 0 || transmission === 0 || wi[2] === 0) return NOTHING;
  return thin ? throughWall(bsdf, wo, wi) : refraction(bsdf, wo, wi);
}

/**
 * Draws wi. u is where on the lobe; `lobe` in [0, 1) tells which: a facet, which reflects or lets through, or the base.
 */
export function bsdfSample(bsdf: Bsdf, wo: Vec3, u: readonly [number, number], lobe: number): BsdfSample {
  const facets = facetProbability(bsdf, wo[2]);
  const isFacet = lobe < facets;
  let facet = facetSeen(bsdf, wo, u);
  let wi = mirrored(wo, facet);
  if (!isFacet) {
    wi = cosineDirection(u);
    facet = halfway(bsdf, add(wo, wi));
  }
  const split = splitAt(bsdf, facet.cosine);
  if (isFacet && lobe >= facets * split.reflection) {
    const through = bsdf.thin ? sampleWall : sampleRefraction;
    return through(bsdf, wo, facet, split, facets * (1 - split.reflection));
  }
  if (isFacet && bsdf.alpha === 0)
    return { wi, weight: scale(split.reflected, 1 / (facets * split.reflection)), pdf: 0 };
  if (!(wi[2] > 0)) return { wi, weight: BLACK, pdf: 0 };
  // By the facet that was drawn: of a narrow lobe the rounded directions do not tell it.
  const { value, pdf } = reflection(bsdf, wo, wi, facet.density, split, facets);
  return { wi, weight: scale(value, 1 / pdf), pdf };
}
