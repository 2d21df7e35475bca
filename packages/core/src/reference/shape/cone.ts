/** Twin of shaders/shape/cone.glsl. */
import { coneAxes } from '../../primitives/cone-shape.ts';
import { perpendicular } from '../../primitives/cylinder-shape.ts';
import type { Shape } from '../../schema.ts';
import { addScaled, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../../vector.ts';
import type { Ray } from '../ray.ts';
import { belowPlane, bothOf, convexDistance, type Interval, NEVER } from './convex.ts';

const slopeOf = ({ base, tip, radius }: Shape<'cone'>): number => radius / length(subtract(base, tip));

/** Distance t > 0 along the ray to the nearest part of the surface, or MISS. */
export function coneDistance(shape: Shape<'cone'>, { origin, direction }: Ray, own: boolean): number {
  const { axis } = coneAxes(shape);
  const toTip = subtract(shape.tip, origin);
  const start = approach(toTip, direction, shape);
  const [first, second] = coneNappe(slopeOf(shape), addScaled(toTip, direction, -start), axis, direction);
  const base = belowPlane(dot(axis, direction), dot(axis, subtract(shape.base, origin)));
  return convexDistance(bothOf([first + start, second + start], base), own);
}

/**
 * How far the line runs to where it is nearest to the tip, from outside of the ball around the tip that holds the cone: from
 * there on, all that cancels is as small as the cone. 0 inside of a ball of twice its area, where a surface may be near.
 */
function approach(toTip: Vec3, direction: Vec3, { base, tip, radius }: Shape<'cone'>): number {
  const axis = subtract(base, tip);
  const ball = dot(axis, axis) + radius * radius;
  return dot(toTip, toTip) > 2 * ball ? dot(toTip, direction) / dot(direction, direction) : 0;
}

/** Where the line is inside of the nappe that holds the base; v leads to the tip. */
function coneNappe(slope: number, v: Vec3, axis: Vec3, d: Vec3): Interval {
  const [hv, dw, n] = [dot(axis, v), dot(axis, d), cross(d, axis)];
  const p = perpendicular(v, axis);
  const product = (size: number, height: number): number =>
    (size - slope * Math.abs(height)) * (size + slope * Math.abs(height));
  const [a, c] = [product(length(n), dw), product(length(p), hv)];
  const b = dot(d, addScaled(p, axis, -slope * slope * hv));
  const discriminant = coneDiscriminant(slope, v, p, axis, d, [a, b, c]);
  if (discriminant < 0) return NEVER;
  const q = b + (b < 0 ? -Math.sqrt(discriminant) : Math.sqrt(discriminant));
  const first = q === 0 ? 0 : c / q;
  // A line along the cone meets it once; the other crossing is endlessly far, on the other nappe if this one is ahead.
  const second = a === 0 ? (q < 0 ? Number.POSITIVE_INFINITY : Number.NEGATIVE_INFINITY) : q / a;
  const [near, far] = [Math.min(first, second), Math.max(first, second)];
  if (a > 0) return b * dw - a * hv >= 0 ? [near, far] : NEVER;
  return dw > 0 ? [far, Number.POSITIVE_INFINITY] : [Number.NEGATIVE_INFINITY, near];
}

/** In the form in which less cancels; not below 0 where the line cannot pass by. */
function coneDiscriminant(
  slope: number,
  v: Vec3,
  p: Vec3,
  axis: Vec3,
  d: Vec3,
  [a, b, c]: readonly [number, number, number],
): number {
  const m = cross(v, d);
  const aside = addScaled(m, axis, -dot(m, axis));
  const one = slope * slope * dot(aside, aside);
  const other = dot(p, cross(d, axis));
  const discriminant = b * b + Math.abs(a * c) < one + other * other ? b * b - a * c : one - other * other;
  return a <= 0 || c < 0 ? Math.max(discriminant, 0) : discriminant;
}

/** Whether a point is on the base: further outside of that than of the side, or less inside. */
function isOnBase(shape: Shape<'cone'>, point: Vec3): boolean {
  const { axis } = coneAxes(shape);
  const slope = slopeOf(shape);
  const fromTip = subtract(point, shape.tip);
  const side = (length(perpendicular(fromTip, axis)) - slope * dot(axis, fromTip)) / Math.sqrt(1 + slope * slope);
  return dot(axis, subtract(point, shape.base)) > side;
}

/** The outward unit normal at a point of the cone; at the tip, where there is none, the axis. */
export function coneNormal(shape: Shape<'cone'>, point: Vec3): Vec3 {
  const { axis } = coneAxes(shape);
  if (isOnBase(shape, point)) return axis;
  const p = perpendicular(subtract(point, shape.tip), axis);
  if (length(p) === 0) return scale(axis, -1);
  return normalize(addScaled(normalize(p), axis, -slopeOf(shape)));
}

/** On the side the arc at this height and the height above the base, on the base lengths along tangent and bitangent. */
export function coneLengths(shape: Shape<'cone'>, point: Vec3): readonly [number, number] {
  const { axis, tangent, bitangent } = coneAxes(shape);
  const p = perpendicular(subtract(point, shape.tip), axis);
  const [u, v] = [dot(tangent, p), dot(bitangent, p)];
  if (isOnBase(shape, point)) return [u, v];
  return [length(p) * Math.atan2(v, u), dot(axis, subtract(shape.base, point))];
}
