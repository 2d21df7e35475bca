/** Twin of shaders/shape/torus.glsl, which says where the formulas come from. */
import { planeAxes } from '../../primitives/plane.ts';
import { ringUnit } from '../../primitives/torus.ts';
import type { Shape } from '../../schema.ts';
import { addScaled, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../../vector.ts';
import { MISS, type Ray } from '../ray.ts';

type Triple = readonly [number, number, number];

/** Distance t > 0 along the ray to the nearest point of the torus, or MISS. */
export function torusDistance(shape: Shape<'torus'>, { origin, direction }: Ray, own: boolean): number {
  const unit = ringUnit(shape.radius);
  const line = new Line(shape, scale(subtract(shape.center, origin), unit), direction, unit);
  const t = line.distance(own);
  return t === MISS ? MISS : t / unit;
}

/** A ray in units of about the ring's radius, counted from where it is nearest to the centre: s = 0. */
class Line {
  readonly #radius: number;
  readonly #tube: number;
  /** The nearest point: t = near + (s - rest). */
  readonly #near: number;
  readonly #rest: number;
  /** Height over the ring's plane and what is level with it (turned by a right angle), and their growth with s. */
  readonly #height: number;
  readonly #climb: number;
  readonly #level: Vec3;
  readonly #across: Vec3;
  /** s⁴ + 2 h s² + 4 j s + … has the sign of the ray's distance to the surface, but for directions of unit length. */
  readonly #h: number;
  readonly #j: number;
  /** Of the origin: below 0 inside; and whether the ray gets away from the centre line. */
  readonly #inside: boolean;
  readonly #leaving: boolean;

  constructor({ axis, radius, tube }: Shape<'torus'>, c: Vec3, d: Vec3, unit: number) {
    const { normal } = planeAxes({ normal: axis });
    this.#radius = radius * unit;
    this.#tube = tube * unit;
    const a = dot(d, d);
    this.#near = dot(c, d) / a;
    const roughly = addScaled(scale(c, -1), d, this.#near);
    this.#rest = dot(roughly, d) / a;
    const x = addScaled(roughly, d, -this.#rest);
    this.#height = dot(x, normal);
    this.#climb = dot(d, normal);
    this.#level = cross(x, normal);
    this.#across = cross(d, normal);
    const squares = (this.#radius - this.#tube) * (this.#radius + this.#tube);
    const ring2 = 2 * this.#radius * this.#radius;
    this.#h = dot(x, x) + squares - ring2 * dot(this.#across, this.#across);
    this.#j = -ring2 * dot(this.#level, this.#across);
    const away = fromRing(this.#radius, normal, scale(c, -1));
    this.#inside = length(away) < this.#tube;
    this.#leaving = dot(away, d) > 0;
  }

  distance(own: boolean): number {
    const start = this.#rest - this.#near;
    const [first, peak, second] = stationary(this.#h, this.#j);
    const values: Triple = [this.quartic(first), this.quartic(peak), this.quartic(second)];
    const inside = own ? !this.#leaving : this.#inside;
    // The valley that the ray enters at the side of its start, or leaves at the other one.
    const atFirst = inside
      ? start < (own ? (first + peak) / 2 : peak) && values[1] >= 0
      : !own && start < first && values[0] < 0;
    const atSecond = inside || (start < (own ? (peak + second) / 2 : second) && values[2] < 0);
    if (!atFirst && !atSecond) return MISS;
    const valley = atFirst ? first : second;
    const depth = -(atFirst ? values[0] : values[2]);
    const inner = atFirst === inside;
    const rise = values[1];
    // Between valley and peak, from whichever is nearer in value.
    const down = inner && rise < depth;
    const towards = inside === down ? -1 : 1;
    const s = this.polished(
      this.fromStationary(down ? peak : valley, towards, down ? -1 : 1, Math.max(down ? rise : depth, 0), inner ? 0.6 * Math.abs(peak - valley) : MISS),
    );
    return Math.max(this.#near + (s - this.#rest), Number.MIN_VALUE);
  }

  /** At s: how far the point is from the axis, and the square of its distance to the centre line less the tube's. */
  at(s: number): { readonly fromAxis: number; readonly power: number; readonly slope: number } {
    const level = addScaled(this.#level, this.#across, s);
    const fromAxis = length(level);
    const height = this.#height + s * this.#climb;
    const away = Math.hypot(fromAxis - this.#radius, height);
    const power = (away - this.#tube) * (away + this.#tube);
    const widening = fromAxis > 0 ? dot(level, this.#across) / fromAxis : 0;
    return { fromAxis, power, slope: 2 * ((fromAxis - this.#radius) * widening + height * this.#climb) };
  }

  quartic(s: number): number {
    const { fromAxis, power } = this.at(s);
    return power * (power + 4 * this.#radius * fromAxis);
  }

  fromStationary(center: number, towards: number, sign: number, level: number, limit: number): number {
    const h = this.#h;
    const linear = Math.max(4 * sign * towards * (center * (center * center + h) + this.#j), 0);
    const half = 2 * towards * center;
    const bend = 2 * (center * center + h);
    const curvature = sign * (half * half + bend);
    const twist = sign * 2 * half;
    let v = Math.min(limit, limit === MISS ? Math.sqrt(Math.sqrt(level)) : MISS);
    if (linear > 0) v = Math.min(v, level / linear);
    if (curvature > 0) v = Math.min(v, Math.sqrt(level / curvature));
    if (twist > 0) v = Math.min(v, Math.cbrt(level / twist));
    for (let i = 0; i < 6; i++) {
      const y = v + half;
      const w = sign * (y * y + bend);
      const slope = linear + v * (2 * w + 2 * v * sign * y);
      if (slope > 0) v = Math.max(v - (v * (linear + v * w) - level) / slope, 0);
    }
    return center + towards * v;
  }

  polished(s: number): number {
    for (let i = 0; i < 2; i++) {
      const { power, slope } = this.at(s);
      if (slope !== 0) s -= power / slope;
    }
    return s;
  }
}

/** Where s⁴ + 2 h s² + 4 j s is stationary: minimum, maximum, minimum. */
function stationary(h: number, j: number): Triple {
  const J = Math.abs(j);
  const u2 = Math.cbrt(J) ** 2;
  let s = h < 0 ? Math.sqrt(u2 - h) : J > 0 ? J / (h + u2) : 0;
  for (let i = 0; i < 6; i++) {
    const slope = 3 * s * s + h;
    if (slope > 0) s -= (s * (s * s + h) - J) / slope;
  }
  const root = Math.sqrt(Math.max(-3 * s * s - 4 * h, 0));
  const other = (s + root) / 2;
  const middle = root > 0 ? J / (s * other) : s / 2;
  return j > 0 ? [-s, middle, other] : [-other, -middle, s];
}

/** The way to a point x, relative to the centre, from the nearest point of the centre line. */
function fromRing(radius: number, axis: Vec3, x: Vec3): Vec3 {
  const level = addScaled(x, axis, -dot(axis, x));
  const fromAxis = length(level);
  return fromAxis > 0 ? addScaled(x, level, -radius / fromAxis) : x;
}

/** The outward unit normal. */
export const torusNormal = ({ center, axis, radius }: Shape<'torus'>, point: Vec3): Vec3 =>
  normalize(fromRing(radius, planeAxes({ normal: axis }).normal, subtract(point, center)));

/** Arcs around the axis on the centre line, and around the tube from its outermost circle towards the axis' tip. */
export function torusLengths({ center, axis, radius, tube }: Shape<'torus'>, point: Vec3): readonly [number, number] {
  const { normal, tangent, bitangent } = planeAxes({ normal: axis });
  const x = subtract(point, center);
  const along = dot(x, tangent);
  const aside = dot(x, bitangent);
  return [radius * Math.atan2(aside, along), tube * Math.atan2(dot(x, normal), Math.hypot(along, aside) - radius)];
}
