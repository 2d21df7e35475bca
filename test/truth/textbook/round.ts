/** Cylinder and cone: P. Heckbert in A. Glassner (ed.), An Introduction to Ray Tracing (1989), in f32. */
import type { Vec3 } from '@ray-scene/core';
import { addScaled, difference, dot, normalize, product, quotient, root, subtract, sum } from './f32.ts';
import { type Intersect, MISS, nearest } from './intersect.ts';

/**
 * The quadratic formula for a side whose radius is `slope` times the height above the start of the axis, or `radius` where
 * that is 0; what is beyond the ends left out.
 */
function side(oc: Vec3, d: Vec3, axis: Vec3, height: number, radius: number, slope: number): readonly number[] {
  const [climb, along] = [dot(d, axis), dot(oc, axis)];
  const stretch = sum(1, product(slope, slope));
  const a = difference(dot(d, d), product(stretch, climb, climb));
  const b = difference(dot(oc, d), product(stretch, along, climb));
  const c = difference(difference(dot(oc, oc), product(stretch, along, along)), product(radius, radius));
  const discriminant = difference(product(b, b), product(a, c));
  if (discriminant < 0) return [];
  const half = root(discriminant);
  return [quotient(difference(-b, half), a), quotient(sum(-b, half), a)].filter((t) => {
    const there = sum(along, product(t, climb));
    return there >= 0 && there <= height;
  });
}

/** The plane equation for a round end. */
function end(o: Vec3, d: Vec3, axis: Vec3, middle: Vec3, radius: number): number {
  const t = quotient(dot(subtract(middle, o), axis), dot(d, axis));
  const aside = subtract(addScaled(o, d, t), middle);
  return dot(aside, aside) <= product(radius, radius) ? t : MISS;
}

type Round = { readonly a: Vec3; readonly b: Vec3; readonly radius: number };

export const cylinder: Intersect = (p, o, d, tmin) => {
  const { a, b, radius } = p as Round;
  const way = subtract(b, a);
  const axis = normalize(way);
  const height = root(dot(way, way));
  const ends = [end(o, d, axis, a, radius), end(o, d, axis, b, radius)];
  return nearest([...side(subtract(o, a), d, axis, height, radius, 0), ...ends], tmin);
};

export const cone: Intersect = (p, o, d, tmin) => {
  const { a, b, radius } = p as Round;
  const way = subtract(a, b);
  const axis = normalize(way);
  const height = root(dot(way, way));
  const slope = quotient(radius, height);
  return nearest([...side(subtract(o, b), d, axis, height, 0, slope), end(o, d, axis, a, radius)], tmin);
};
