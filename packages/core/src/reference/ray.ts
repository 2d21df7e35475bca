/** A ray and what it meets, in f64 and scene coordinates. */
import type { Vec3 } from '../vector.ts';

export interface Ray {
  readonly origin: Vec3;
  /** Unit length up to rounding. */
  readonly direction: Vec3;
  /** The object whose surface the ray leaves: its own root t = 0 is not an intersection. */
  readonly own?: number;
}

/** No intersection. */
export const MISS = Number.POSITIVE_INFINITY;
