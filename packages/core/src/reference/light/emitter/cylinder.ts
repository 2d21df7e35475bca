/** Twin of shaders/light/emitter/cylinder.glsl. */
import type { EmitterOf } from '../../../emitters.ts';
import { add, addScaled, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../../../vector.ts';
import { circle } from '../../circle.ts';
import { tangents } from '../../tangents.ts';
import { areaPdf, areaSample } from './area.ts';
import { aroundDirection, insidePdf, insideSample } from './inside.ts';
import type { EmitterSample } from './sample.ts';

/** A cylinder as it is seen from a point. */
interface Seen {
  readonly axis: Vec3;
  /** Above the base along the axis. */
  readonly height: number;
  /** From the axis to the point, at right angles. */
  readonly out: Vec3;
  readonly away: number;
  /** How far around from `out` the side is seen, to both sides, in radians; 0: not at all. */
  readonly around: number;
  readonly sideArea: number;
  /** Of a cap, if one is seen. */
  readonly capArea: number;
}

/** From outside, points of what is seen of it, all equally likely; from inside, all directions are. */
export function cylinderSample(
  cylinder: EmitterOf<'cylinder'>,
  p: Vec3,
  u: readonly [number, number],
  own: boolean,
): EmitterSample | undefined {
  const seen = cylinderSeen(cylinder, p);
  const area = seen.sideArea + seen.capArea;
  if (own || area === 0) {
    const direction = aroundDirection(u);
    return insideSample(cylinder, direction, cylinderExit(cylinder, seen, direction, own));
  }
  const place = u[0] * area;
  return place < seen.capArea
    ? capSample(cylinder, p, seen, [place / seen.capArea, u[1]])
    : sideSample(cylinder, p, seen, [(place - seen.capArea) / seen.sideArea, u[1]]);
}

export function cylinderPdf(
  cylinder: EmitterOf<'cylinder'>,
  from: Vec3,
  t: number,
  cosine: number,
  own: boolean,
): number {
  const { sideArea, capArea } = cylinderSeen(cylinder, from);
  return own || sideArea + capArea === 0 ? insidePdf(cylinder) : areaPdf(t, cosine, sideArea + capArea);
}

function cylinderSeen({ base, top, radius }: EmitterOf<'cylinder'>, p: Vec3): Seen {
  const tall = length(subtract(top, base));
  const axis = normalize(subtract(top, base));
  const fromBase = subtract(p, base);
  const height = dot(axis, fromBase);
  const out = cross(cross(axis, fromBase), axis);
  const away = length(out);
  const around = away > radius ? Math.atan2(Math.sqrt((away - radius) * (away + radius)), radius) : 0;
  return {
    axis,
    height,
    out,
    away,
    around,
    sideArea: 2 * around * radius * tall,
    capArea: height < 0 || height > tall ? Math.PI * radius * radius : 0,
  };
}

function capSample(
  cylinder: EmitterOf<'cylinder'>,
  p: Vec3,
  { axis, height, sideArea, capArea }: Seen,
  u: readonly [number, number],
): EmitterSample | undefined {
  const [x, y] = tangents(axis);
  const [cosine, sine] = circle(u[1]);
  const out = cylinder.radius * Math.sqrt(u[0]);
  const middle = subtract(height < 0 ? cylinder.base : cylinder.top, p);
  const way = add(middle, addScaled(scale(x, out * cosine), y, out * sine));
  const above = height < 0 ? -height : height - length(subtract(cylinder.top, cylinder.base));
  return areaSample(cylinder, way, above, sideArea + capArea, true);
}

function sideSample(
  cylinder: EmitterOf<'cylinder'>,
  p: Vec3,
  { axis, out, away, around, sideArea, capArea }: Seen,
  u: readonly [number, number],
): EmitterSample | undefined {
  const turn = 2 * u[0] - 1;
  const [cosine, sine] = circle((Math.abs(turn) * around) / (2 * Math.PI));
  const toPoint = scale(out, 1 / away);
  const normal = addScaled(scale(toPoint, cosine), cross(axis, toPoint), turn < 0 ? -sine : sine);
  const foot = addScaled(subtract(cylinder.base, p), subtract(cylinder.top, cylinder.base), u[1]);
  // Above the tangent plane: away cos - radius, which cancels near the outline, as away times a difference of cosines.
  const above =
    2 * away * Math.sin((around * (1 - Math.abs(turn))) / 2) * Math.sin((around * (1 + Math.abs(turn))) / 2);
  return areaSample(cylinder, addScaled(foot, normal, cylinder.radius), above, sideArea + capArea, true);
}

/** How far the surface is from a point inside; 0 for directions out of the part of it that the point is on. */
function cylinderExit(
  { base, top, radius }: EmitterOf<'cylinder'>,
  { axis, height, out, away }: Seen,
  direction: Vec3,
  own: boolean,
): number {
  const tall = length(subtract(top, base));
  const up = dot(axis, direction);
  const across = addScaled(direction, axis, -up);
  const outward = dot(out, direction);
  const depths = [Math.abs(radius - away), Math.abs(height), Math.abs(tall - height)] as const;
  const nearest = Math.min(...depths);
  const leaving = nearest === depths[0] ? outward : nearest === depths[1] ? -up : up;
  if (own && leaving > 0) return 0;
  const a = dot(across, across);
  const power = (away - radius) * (away + radius);
  const root = Math.sqrt(Math.max(outward * outward - a * power, 0));
  const side = outward < 0 ? (root - outward) / a : -power / (outward + root);
  const cap = up > 0 ? (tall - height) / up : -height / up;
  return Math.min(a > 0 ? side : Number.POSITIVE_INFINITY, up === 0 ? Number.POSITIVE_INFINITY : cap);
}
