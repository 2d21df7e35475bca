/** Twin of shaders/shape/convex.glsl: a line is inside of a convex solid from t[0] to t[1], or never where t[0] > t[1]. */
import { MISS } from '../ray.ts';

export type Interval = readonly [number, number];

export const NEVER: Interval = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
export const ALWAYS: Interval = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];

/**
 * The nearest way in or out that is ahead, or MISS. Of a ray that leaves the solid's own surface, the crossing nearer to 0
 * is the one where it starts: whatever was rounded, it is left out.
 */
export function convexDistance([first, second]: Interval, own: boolean): number {
  const nearest = first > 0 && !own ? first : second;
  const least = own ? -first : 0;
  return first <= second && nearest > least ? nearest : MISS;
}

/** The part of the line for which t rate <= height. */
export function belowPlane(rate: number, height: number): Interval {
  if (rate === 0) return height < 0 ? NEVER : ALWAYS;
  return rate > 0 ? [ALWAYS[0], height / rate] : [height / rate, ALWAYS[1]];
}

export const bothOf = (a: Interval, b: Interval): Interval => [Math.max(a[0], b[0]), Math.min(a[1], b[1])];
