/** What all of the textbook's functions do. */
import type { Vec3 } from '@ray-scene/core';
import type { Shape } from '../vector-cases.ts';

export const MISS = Number.POSITIVE_INFINITY;

/** The distance along a ray, or MISS. */
export type Intersect = (p: Shape, o: Vec3, d: Vec3, tmin: number) => number;

/** Of all places where a ray meets something, the first that counts. */
export const nearest = (places: readonly number[], tmin: number): number =>
  Math.min(MISS, ...places.filter((t) => t > tmin && Number.isFinite(t)));
