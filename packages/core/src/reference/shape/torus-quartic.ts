/** Twin of shaders/shape/torus-quartic.glsl: a quartic's stationary points, and the root that a ray meets first. */

/** The quartic s⁴ + 2 h s² + 4 j s + …, as far as it does not depend on the place. */
interface Quartic {
  readonly h: number;
  readonly j: number;
}

/** A minimum, a maximum and a minimum in their order, or the values there. */
export type Stationary = readonly [first: number, peak: number, second: number];

/** Where to look for a root, from a stationary point on. */
interface Search {
  readonly center: number;
  readonly towards: 1 | -1;
  readonly rising: 1 | -1;
  readonly level: number;
  readonly bound: number;
}

/** Enough from where the shader's 3 steps get: each doubles the digits. */
const STEPS = 5;

export function torusStationary({ h, j }: Quartic): Stationary {
  const size = Math.abs(j);
  const square = Math.cbrt(size) ** 2;
  let largest = h < 0 ? Math.sqrt(square - h) : size > 0 ? size / (h + square) : 0;
  for (let i = 0; i < STEPS; i++) {
    const slope = 3 * largest * largest + h;
    if (slope > 0) largest -= (largest * (largest * largest + h) - size) / slope;
  }
  const root = Math.sqrt(Math.max(-3 * largest * largest - 4 * h, 0));
  const least = (largest + root) / 2;
  const middle = root > 0 ? size / (largest * least) : largest / 2;
  return j > 0 ? [-largest, middle, least] : [-least, -middle, largest];
}

/** `start` is where the ray starts; undefined: it meets nothing. */
export function torusSearch(
  [first, peak, second]: Stationary,
  [atFirst, atPeak, atSecond]: Stationary,
  start: number,
  inside: boolean,
  own: boolean,
): Search | undefined {
  const beforeFirst = !own && start < first;
  const beforePeak = start < (own ? (first + peak) / 2 : peak);
  const beforeSecond = start < (own ? (peak + second) / 2 : second);
  const valleyIsFirst = inside ? beforePeak && atPeak >= 0 : beforeFirst && atFirst < 0;
  if (!inside && !valleyIsFirst && !(beforeSecond && atSecond < 0)) return undefined;

  const valley = valleyIsFirst ? first : second;
  const depth = -(valleyIsFirst ? atFirst : atSecond);
  const inner = valleyIsFirst === inside;
  const down = inner && atPeak < depth;
  const level = Math.max(down ? atPeak : depth, 0);
  return {
    center: down ? peak : valley,
    towards: inside === down ? -1 : 1,
    rising: down ? -1 : 1,
    level,
    bound: inner ? 0.6 * Math.abs(peak - valley) : Math.sqrt(Math.sqrt(level)),
  };
}

export function torusRoot({ center, towards, rising, level, bound }: Search, { h, j }: Quartic): number {
  const curved = center * center + h;
  const linear = Math.max(4 * rising * towards * (center * curved + j), 0);
  const shift = 2 * towards * center;
  const square = rising * (shift * shift + 2 * curved);
  const cube = 2 * rising * shift;
  let v = bound;
  if (linear > 0) v = Math.min(v, level / linear);
  if (square > 0) v = Math.min(v, Math.sqrt(level / square));
  if (cube > 0) v = Math.min(v, Math.cbrt(level / cube));
  for (let i = 0; i < STEPS; i++) {
    const y = v + shift;
    const w = rising * (y * y + 2 * curved);
    const slope = linear + 2 * v * (w + v * rising * y);
    // Roots are within 1 of the centre.
    if (slope > 0) v = Math.min(Math.max(v - (v * (linear + v * w) - level) / slope, 0), 2);
  }
  return center + towards * v;
}
