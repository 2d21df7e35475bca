/** Ray against shape as textbooks have it, in f32: what the numbers of this project stand beside. */
import type { Vec3 } from '@ray-scene/core';
import type { Shape, VectorCase, VectorKind } from '../vector-cases.ts';
import { cross, dot, subtract } from './f32.ts';

const f = Math.fround;
const MISS = Number.POSITIVE_INFINITY;

type Intersect = (p: Shape, o: Vec3, d: Vec3, tmin: number) => number;

const nearer = (near: number, far: number, tmin: number): number => (near > tmin ? near : far > tmin ? far : MISS);

/** The quadratic formula. */
const sphere: Intersect = ({ center, radius }, o, d, tmin) => {
  const oc = subtract(o, center as Vec3);
  const a = dot(d, d);
  const b = f(2 * dot(oc, d));
  const c = f(dot(oc, oc) - f((radius as number) * (radius as number)));
  const discriminant = f(f(b * b) - f(f(4 * a) * c));
  if (discriminant < 0) return MISS;
  const root = f(Math.sqrt(discriminant));
  return nearer(f(f(-b - root) / f(2 * a)), f(f(-b + root) / f(2 * a)), tmin);
};

const plane: Intersect = ({ point, normal }, o, d, tmin) => {
  const t = f(dot(subtract(point as Vec3, o), normal as Vec3) / dot(d, normal as Vec3));
  return t > tmin && Number.isFinite(t) ? t : MISS;
};

/** T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997. */
const triangle: Intersect = ({ a, b, c }, o, d, tmin) => {
  const [edge1, edge2] = [subtract(b as Vec3, a as Vec3), subtract(c as Vec3, a as Vec3)];
  const p = cross(d, edge2);
  const determinant = dot(edge1, p);
  const s = subtract(o, a as Vec3);
  const u = f(dot(s, p) / determinant);
  const q = cross(s, edge1);
  const v = f(dot(d, q) / determinant);
  const t = f(dot(edge2, q) / determinant);
  return u >= 0 && v >= 0 && f(u + v) <= 1 && t > tmin && Number.isFinite(t) ? t : MISS;
};

/** Slabs, with the reciprocal of the direction. */
const box: Intersect = ({ min, max }, o, d, tmin) => {
  let [near, far] = [Number.NEGATIVE_INFINITY, MISS];
  for (let i = 0; i < 3; i++) {
    const inverse = f(1 / (d[i] as number));
    const t = [min, max].map((corner) => f(f(((corner as Vec3)[i] as number) - (o[i] as number)) * inverse));
    near = Math.max(near, Math.min(...t));
    far = Math.min(far, Math.max(...t));
  }
  return near <= far ? nearer(near, far, tmin) : MISS;
};

const textbook: { readonly [K in VectorKind]?: Intersect } = { sphere, plane, triangle, box };

/** The distance that the textbook finds in a case; undefined: it is not here. */
export const textbookDistance = ({ prim, p, o, d, tmin }: VectorCase): number | undefined =>
  textbook[prim]?.(p, o, d, tmin);
