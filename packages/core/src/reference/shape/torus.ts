/** Twin of shaders/shape/torus.glsl, which says what the formulas are and where they come from. */
import { planeAxes } from '../../primitives/plane.ts';
import { awayFromRing, ringUnit } from '../../primitives/torus-shape.ts';
import type { Shape } from '../../schema.ts';
import { addScaled, cross, dot, length, negate, normalize, scale, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

/** The torus, its lengths in ring units. */
interface Ring {
  readonly axis: Vec3;
  readonly radius: number;
  readonly tube: number;
}

/** A ray from its point nearest to the centre on; `level` and `across` are turned by a right angle. */
interface Line {
  readonly near: number;
  readonly rest: number;
  readonly height: number;
  readonly climb: number;
  readonly level: Vec3;
  readonly across: Vec3;
}

/** The quartic s⁴ + 2 h s² + 4 j s + …, as far as it does not depend on the place. */
interface Quartic {
  readonly h: number;
  readonly j: number;
}

/** A minimum, a maximum and a minimum in their order, or the values there. */
type Stationary = readonly [first: number, peak: number, second: number];

/** Where to look for a root, from a stationary point on. */
interface Search {
  readonly center: number;
  readonly towards: 1 | -1;
  readonly rising: 1 | -1;
  readonly level: number;
  readonly bound: number;
}

/** Distance t > 0 along the ray to the nearest point of the torus, or MISS. A ray that leaves it may meet it again. */
export function torusDistance(shape: Shape<'torus'>, { origin, direction }: Ray, own: boolean): number {
  const unit = ringUnit(shape.radius);
  const ring = { axis: normalize(shape.axis), radius: shape.radius * unit, tube: shape.tube * unit };
  const c = scale(subtract(shape.center, origin), unit);
  const line = torusLine(ring, c, direction);
  const aside2 = line.height ** 2 + dot(line.level, line.level);
  // With room for rounding.
  if (aside2 > 1.001 * (ring.radius + ring.tube) ** 2) return MISS;

  const twice = 2 * ring.radius * ring.radius;
  const quartic = {
    h: aside2 + (ring.radius - ring.tube) * (ring.radius + ring.tube) - twice * dot(line.across, line.across),
    j: -twice * dot(line.level, line.across),
  };
  const away = awayFromRing({ center: c, ...ring }, [0, 0, 0]);
  const inside = own ? dot(away, direction) < 0 : length(away) < ring.tube;
  const search = torusSearch(ring, line, torusStationary(quartic), inside, own);
  if (!search) return MISS;
  const { center } = search;
  const s = torusPowerStep(ring, line, torusPowerStep(ring, line, torusRoot(search, quartic), center), center);
  // A root that rounding has put behind the start is met at once.
  return Math.max((line.near + (s - line.rest)) / unit, Number.MIN_VALUE);
}

function torusLine({ axis }: Ring, c: Vec3, d: Vec3): Line {
  const near = dot(c, d) / dot(d, d);
  const roughly = addScaled(negate(c), d, near);
  const rest = dot(roughly, d) / dot(d, d);
  const x = addScaled(roughly, d, -rest);
  return { near, rest, height: dot(x, axis), climb: dot(d, axis), level: cross(x, axis), across: cross(d, axis) };
}

/** At a place on the line: the power, how it grows, and the quartic. */
function torusAt({ radius, tube }: Ring, { height, climb, level, across }: Line, place: number) {
  const there = addScaled(level, across, place);
  const fromAxis = length(there);
  const beside = fromAxis - radius;
  const over = height + place * climb;
  const distance = Math.hypot(beside, over);
  const power = (distance - tube) * (distance + tube);
  const widening = fromAxis > 0 ? dot(there, across) / fromAxis : 0;
  return { power, slope: 2 * (beside * widening + over * climb), quartic: power * (power + 4 * radius * fromAxis) };
}

/** One step of Newton's method on the power, no farther than the place is from the stationary point `center`. */
function torusPowerStep(ring: Ring, line: Line, place: number, center: number): number {
  const { power, slope } = torusAt(ring, line, place);
  const most = Math.abs(place - center);
  return slope === 0 ? place : place - Math.min(Math.max(power / slope, -most), most);
}

/** Enough from where the shader's 3 steps get: each doubles the digits. */
const STEPS = 5;

function torusStationary({ h, j }: Quartic): Stationary {
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

function torusSearch(
  ring: Ring,
  line: Line,
  stationary: Stationary,
  inside: boolean,
  own: boolean,
): Search | undefined {
  const [first, peak, second] = stationary;
  const [atFirst, atPeak, atSecond] = stationary.map(
    (place) => torusAt(ring, line, place).quartic,
  ) as unknown as Stationary;
  const start = line.rest - line.near;
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

function torusRoot({ center, towards, rising, level, bound }: Search, { h, j }: Quartic): number {
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

/** The outward unit normal at a point of the torus. */
export const torusNormal = (shape: Shape<'torus'>, point: Vec3): Vec3 => normalize(awayFromRing(shape, point));

/** Arc lengths around the axis on the ring's centre line, from the tangent, and around the tube from its outer circle. */
export function torusLengths({ center, axis, radius, tube }: Shape<'torus'>, point: Vec3): readonly [number, number] {
  const { normal, tangent, bitangent } = planeAxes({ normal: axis });
  const x = subtract(point, center);
  const along = dot(x, tangent);
  const aside = dot(x, bitangent);
  return [radius * Math.atan2(aside, along), tube * Math.atan2(dot(x, normal), Math.hypot(along, aside) - radius)];
}
