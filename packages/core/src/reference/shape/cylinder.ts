/** Twin of shaders/shape/cylinder.glsl. */
import { perpendicular, roundAxes } from '../../primitives/cylinder-shape.ts';
import type { Shape } from '../../schema.ts';
import { cross, dot, length, scale, subtract, type Vec3 } from '../../vector.ts';
import type { Ray } from '../ray.ts';
import { ALWAYS, belowPlane, bothOf, convexDistance, type Interval, NEVER } from './convex.ts';

/** Distance t > 0 along the ray to the nearest part of the surface, or MISS. */
export function cylinderDistance(shape: Shape<'cylinder'>, { origin, direction }: Ray, own: boolean): number {
  const { axis } = roundAxes(shape.base, shape.top);
  const rate = dot(axis, direction);
  const below = belowPlane(rate, dot(axis, subtract(shape.top, origin)));
  const above = belowPlane(-rate, -dot(axis, subtract(shape.base, origin)));
  const side = cylinderSide(shape.radius, perpendicular(subtract(shape.base, origin), axis), axis, direction);
  return convexDistance(bothOf(side, bothOf(below, above)), own);
}

/** Where the line is inside of the endless cylinder; p leads to its axis. */
function cylinderSide(radius: number, p: Vec3, axis: Vec3, d: Vec3): Interval {
  const n = cross(d, axis);
  const a = dot(n, n);
  const k = (length(p) - radius) * (length(p) + radius);
  if (a === 0) return k <= 0 ? ALWAYS : NEVER;
  const b = dot(p, d);
  const m = dot(d, cross(axis, p));
  const exact = b * b < a * radius * radius ? b * b - a * k : a * radius * radius - m * m;
  const discriminant = k < 0 ? Math.max(exact, 0) : exact;
  if (discriminant < 0) return NEVER;
  const q = b + (b < 0 ? -Math.sqrt(discriminant) : Math.sqrt(discriminant));
  const [first, second] = q === 0 ? [0, 0] : [k / q, q / a];
  return [Math.min(first, second), Math.max(first, second)];
}

/** The way along the axis beyond the nearer cap and that beyond the side; below 0 inside. */
function beyond(shape: Shape<'cylinder'>, point: Vec3): { readonly cap: number; readonly side: number; p: Vec3 } {
  const { axis } = roundAxes(shape.base, shape.top);
  const p = perpendicular(subtract(point, shape.base), axis);
  const cap = Math.max(dot(axis, subtract(shape.base, point)), dot(axis, subtract(point, shape.top)));
  return { cap, side: length(p) - shape.radius, p };
}

/** The outward unit normal at a point of the cylinder. */
export function cylinderNormal(shape: Shape<'cylinder'>, point: Vec3): Vec3 {
  const { axis } = roundAxes(shape.base, shape.top);
  const { cap, side, p } = beyond(shape, point);
  if (cap <= side) return scale(p, 1 / length(p));
  return dot(axis, subtract(point, shape.top)) === cap ? axis : scale(axis, -1);
}

/** On the side arc and height, on the caps lengths along tangent and axis × tangent. */
export function cylinderLengths(shape: Shape<'cylinder'>, point: Vec3): readonly [number, number] {
  const { axis, tangent, bitangent } = roundAxes(shape.base, shape.top);
  const { cap, side, p } = beyond(shape, point);
  const [u, v] = [dot(tangent, p), dot(bitangent, p)];
  return cap > side ? [u, v] : [shape.radius * Math.atan2(v, u), dot(axis, subtract(point, shape.base))];
}
