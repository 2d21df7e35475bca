/** Ray against shape as textbooks have it, in f32: what the numbers of this project stand beside. */
import type { Vec3 } from '@ray-scene/core';
import type { VectorCase, VectorKind } from '../vector-cases.ts';
import { addScaled, cross, dot, product, scale, subtract } from './f32.ts';
import { type Intersect, MISS, nearest } from './intersect.ts';
import { cone, cylinder } from './round.ts';
import { torus } from './torus.ts';

const f = Math.fround;

/** The quadratic formula. */
const sphere: Intersect = ({ center, radius }, o, d, tmin) => {
  const oc = subtract(o, center as Vec3);
  const a = dot(d, d);
  const b = f(2 * dot(oc, d));
  const c = f(dot(oc, oc) - f((radius as number) * (radius as number)));
  const discriminant = f(f(b * b) - f(f(4 * a) * c));
  if (discriminant < 0) return MISS;
  const root = f(Math.sqrt(discriminant));
  return nearest([f(f(-b - root) / f(2 * a)), f(f(-b + root) / f(2 * a))], tmin);
};

const plane: Intersect = ({ point, normal }, o, d, tmin) => {
  const t = f(dot(subtract(point as Vec3, o), normal as Vec3) / dot(d, normal as Vec3));
  return nearest([t], tmin);
};

/** The plane, and the distance from the centre there. */
const disc: Intersect = (p, o, d, tmin) => {
  const t = plane({ point: p.center as Vec3, normal: p.normal as Vec3 }, o, d, tmin);
  const aside = subtract(addScaled(o, d, t), p.center as Vec3);
  return dot(aside, aside) <= product(p.radius as number, p.radius as number) ? t : MISS;
};

/** The plane, and coordinates in it: P. Shirley, T. D. Black, S. Hollasch, "Ray Tracing: The Next Week", section 6. */
const quad: Intersect = ({ corner, edgeU, edgeV }, o, d, tmin) => {
  const [q, u, v] = [corner, edgeU, edgeV] as [Vec3, Vec3, Vec3];
  const normal = cross(u, v);
  const w = scale(normal, f(1 / dot(normal, normal)));
  const t = f(f(dot(normal, q) - dot(normal, o)) / dot(normal, d));
  const inPlane = subtract(addScaled(o, d, t), q);
  const [alpha, beta] = [dot(w, cross(inPlane, v)), dot(w, cross(u, inPlane))];
  return alpha >= 0 && alpha <= 1 && beta >= 0 && beta <= 1 ? nearest([t], tmin) : MISS;
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
  return u >= 0 && v >= 0 && f(u + v) <= 1 ? nearest([t], tmin) : MISS;
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
  return near <= far ? nearest([near, far], tmin) : MISS;
};

const textbook: { readonly [K in VectorKind]: Intersect } = {
  sphere,
  plane,
  disc,
  quad,
  box,
  cylinder,
  cone,
  torus,
  triangle,
};

/** The distance that the textbook finds in a case. */
export const textbookDistance = ({ prim, p, o, d, tmin }: VectorCase): number => textbook[prim](p, o, d, tmin);
