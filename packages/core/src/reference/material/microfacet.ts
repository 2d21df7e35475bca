/** Twin of shaders/material/microfacet.glsl: GGX, in the frame of the surface, whose normal is z. alpha is above 0. */
import { dot, scale, type Vec3 } from '../../vector.ts';
import { circle } from '../circle.ts';

/** A normal of the microsurface that is seen from a direction wo. */
export interface Facet {
  readonly normal: Vec3;
  /** Between the normal and wo. */
  readonly cosine: number;
  /** D at the normal. */
  readonly density: number;
}

/**
 * D, for a half vector of any length with h.z > 0. 1 - cos² is taken from h.x and h.y, so that nothing cancels however
 * narrow the lobe is.
 */
export function ggx(alpha: number, h: Vec3): number {
  const [x, y, z] = h;
  const root = (alpha * dot(h, h)) / (x * x + y * y + alpha * alpha * z * z);
  return (root * root) / Math.PI;
}

/** G1 of Smith over the cosine, for a cosine in [0, 1]: a number at 0 too. */
export const smithOverCosine = (alpha: number, cosine: number): number =>
  2 / (cosine + Math.sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine));

/**
 * A visible normal, with the probability density G1(wo) D(h) (wo·h) / wo.z.
 * Source: J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", Computer Graphics Forum 42(8), 2023.
 */
export function visibleNormal(alpha: number, wo: Vec3, [angle, share]: readonly [number, number]): Facet {
  // Stretched along z so that the microsurface is a hemisphere.
  const size = Math.hypot(alpha * wo[0], alpha * wo[1], wo[2]);
  const v: Vec3 = [(alpha * wo[0]) / size, (alpha * wo[1]) / size, wo[2] / size];
  // What is mirrored by a hemisphere goes evenly to the cap -v.z < z <= 1. Written by what adds up, not by what cancels.
  const cap = 1 + v[2];
  const height = cap * (1 - share);
  const radius = Math.sqrt(share * (cap * height + v[0] * v[0] + v[1] * v[1]));
  const [x, y] = circle(angle);
  const h: Vec3 = [radius * x + v[0], radius * y + v[1], height];
  const unstretched: Vec3 = [alpha * h[0], alpha * h[1], h[2]];
  const stretched2 = dot(h, h);
  const length2 = dot(unstretched, unstretched);
  const root = length2 / (alpha * stretched2);
  return {
    normal: scale(unstretched, 1 / Math.sqrt(length2)),
    // v·h is half of h·h, since h is the sum of v and of what v is mirrored to.
    cosine: Math.min((size * stretched2) / (2 * Math.sqrt(length2)), 1),
    density: (root * root) / Math.PI,
  };
}
