/** Twin of shaders/material/dielectric.glsl. */
import { addScaled, scale, type Vec3 } from '../../vector.ts';

/**
 * (eta times the cosine of the refracted direction)², for a direction that makes the given cosine in [0, 1] with the
 * normal; below 0, all of it is reflected. eta is the index of refraction behind the surface over that in front.
 */
export const refractedCosine2 = (cosine: number, eta: number): number => (eta - 1) * (eta + 1) + cosine * cosine;

/**
 * Fresnel reflectance of a dielectric, exact and unpolarised. In place of cos - eta cos' there is its product with
 * cos + eta cos', which is 1 - eta²: nothing cancels, and where eta is 1 there is no reflection.
 */
export function exactFresnel(cosine: number, eta: number): number {
  const behind2 = refractedCosine2(cosine, eta);
  if (behind2 < 0) return 1;
  const sum = cosine + Math.sqrt(behind2);
  const step = (eta - 1) * (eta + 1);
  if (step === 0) return 0;
  const s = step / (sum * sum);
  const p = (step * (cosine * sum - 1)) / (sum * (eta * eta * cosine + Math.sqrt(behind2)));
  return Math.min((s * s + p * p) / 2, 1);
}

/** Where wo, which makes the cosine with h, goes behind the surface; both have unit length. There must be such a way. */
export function refracted(wo: Vec3, h: Vec3, cosine: number, eta: number): Vec3 {
  const along = addScaled(wo, h, -cosine);
  return scale(addScaled(along, h, Math.sqrt(refractedCosine2(cosine, eta))), -1 / eta);
}
