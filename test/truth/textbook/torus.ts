/**
 * The quartic of a torus, solved in closed form by way of its resolvent cubic (Ferrari), as shader collections have it, in
 * f32: I. Quilez, "Torus - intersection" (2014).
 */
import type { Vec3 } from '@ray-scene/core';
import { difference, dot, normalize, product, quotient, root, scale, subtract, sum } from './f32.ts';
import { type Intersect, nearest } from './intersect.ts';

type Torus = { readonly center: Vec3; readonly axis: Vec3; readonly major: number; readonly minor: number };

/** In units of the ring, along a unit direction. */
export const torus: Intersect = (p, o, d, tmin) => {
  const { center, axis, major, minor } = p as Torus;
  const unit = quotient(1, major);
  const direction = normalize(d);
  const places = torusPlaces(scale(subtract(o, center), unit), direction, normalize(axis), product(minor, unit));
  const stretch = quotient(major, root(dot(d, d)));
  return nearest(
    places.map((t) => product(t, stretch)),
    tmin,
  );
};

/** The numbers k3 to k0 of t⁴ + 4 k3 t³ + 4 k2 t² + 8 k1 t + 4 k0. */
function quarticOf(o: Vec3, d: Vec3, axis: Vec3, tube: number): readonly [number, number, number, number] {
  const tube2 = product(tube, tube);
  const n = dot(o, d);
  const k = quotient(difference(difference(dot(o, o), tube2), 1), 2);
  const [climb, height] = [dot(d, axis), dot(o, axis)];
  const k0 = difference(sum(product(k, k), product(height, height)), tube2);
  return [n, sum(product(n, n), product(climb, climb), k), sum(product(k, n), product(height, climb)), k0];
}

/** k3 (k3² - k2) + k1 */
const slant = (k3: number, k2: number, k1: number): number => sum(product(k3, difference(product(k3, k3), k2)), k1);

function torusPlaces(o: Vec3, d: Vec3, axis: Vec3, tube: number): readonly number[] {
  const [k3, k2, k1, k0] = quarticOf(o, d, axis, tube);
  // Near where the closed form divides by 0, the quartic of u = 2 / t, which is of the same form.
  if (Math.abs(slant(k3, k2, k1)) >= 0.01) return quarticRoots(k3, k2, k1, k0);
  const over = quotient(1, k0);
  return quarticRoots(product(k1, over), product(k2, over), product(k3, over), over).map((u) => quotient(2, u));
}

function quarticRoots(k3: number, k2: number, k1: number, k0: number): readonly number[] {
  const k33 = product(k3, k3);
  const c2 = quotient(difference(product(2, k2), product(3, k33)), 3);
  const c1 = product(2, slant(k3, k2, k1));
  const inner = difference(product(k3, sum(product(-3, k33), product(4, k2))), product(8, k1));
  const c0 = quotient(sum(product(k3, inner), product(4, k0)), 3);
  const z = difference(c2, resolventRoot(c2, c1, c0));
  const d1 = difference(z, product(3, c2));
  const d2 = difference(product(z, z), product(3, c0));
  const isFlat = Math.abs(d1) < 1e-4;
  if ((isFlat ? d2 : d1) < 0) return [];
  const p = isFlat ? d1 : root(quotient(d1, 2));
  const q = isFlat ? root(d2) : quotient(c1, p);
  const base = difference(product(p, p), z);
  return [...pair(sum(base, q), -p, k3), ...pair(difference(base, q), p, k3)];
}

/** The two roots around `middle` - k3. */
function pair(square: number, middle: number, k3: number): readonly number[] {
  if (!(square > 0)) return [];
  const half = root(square);
  return [difference(difference(middle, half), k3), difference(sum(middle, half), k3)];
}

function resolventRoot(c2: number, c1: number, c0: number): number {
  const q = sum(product(c2, c2), c0);
  const r = difference(difference(product(3, c0, c2), product(c2, c2, c2)), product(c1, c1));
  const h = difference(product(r, r), product(q, q, q));
  if (h < 0) {
    const size = root(q);
    return product(2, size, Math.cos(Math.fround(Math.acos(quotient(r, product(size, q))) / 3)));
  }
  const size = Math.fround(Math.cbrt(sum(root(h), Math.abs(r))));
  return product(Math.sign(r), Math.abs(sum(size, quotient(q, size))));
}
