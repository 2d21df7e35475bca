/** Twin of shaders/shape/torus.glsl, which says what the formulas are and where they come from. */
import { planeAxes } from '../../primitives/plane.ts';
import { awayFromRing, ringUnit } from '../../primitives/torus-shape.ts';
import type { Shape } from '../../schema.ts';
import { addScaled, cross, dot, length, negate, normalize, scale, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';
import { type Stationary, torusRoot, torusSearch, torusStationary } from './torus-quartic.ts';

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
  const stationary = torusStationary(quartic);
  const values = stationary.map((place) => torusAt(ring, line, place).quartic) as unknown as Stationary;
  const search = torusSearch(stationary, values, line.rest - line.near, inside, own);
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
