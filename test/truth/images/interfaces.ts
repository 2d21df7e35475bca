/**
 * Indices of refraction. Theirs says of each interface what is on both sides; ours says what an object is made of, and
 * knows by what contains it what is around it, so that both must agree.
 */
import type { Vec3 } from '@ray-scene/core';
import { tangents } from '../../../packages/core/src/reference/tangents.ts';
import { add, addScaled, dot, length, normalize, scale, subtract } from '../../../packages/core/src/vector.ts';
import type { NeutralObject, NeutralScene } from './neutral-scene.ts';
import { given, Untranslatable } from './untranslatable.ts';

/** Shapes with an inside; of others ours are thin panes, where the other renderer has a single interface. */
const CLOSED = ['sphere', 'box', 'cylinder', 'cone', 'torus'];

/** Index inside of an object over that of what is around all of it: nothing but ratios count. */
export function indexInside(object: NeutralObject, scene: NeutralScene): number {
  if (!CLOSED.includes(object.shape)) throw new Untranslatable(`there is no interface that is a ${object.shape}`);
  const chain = [object, ...around(object, scene)].map((one) => indices(one, scene));
  chain.forEach(({ outside }, i) => {
    const next = chain[i + 1];
    if (next && next.inside !== outside) {
      throw new Untranslatable(
        `there is a medium of ${next.inside} around a ${object.shape}, and the scene says ${outside}`,
      );
    }
  });
  const index = indices(object, scene).inside / (chain.at(-1)?.outside as number);
  if (index < 1)
    throw new Untranslatable(`there is no medium of ${index} times the index of what is around everything`);
  return index;
}

function indices(object: NeutralObject, scene: NeutralScene): { readonly inside: number; readonly outside: number } {
  const material = scene.materials[object.material] ?? { type: '' };
  return { inside: given(material, 'iorInside').iorInside, outside: material.iorOutside ?? 1 };
}

/** What light goes through that contains the object, the innermost first. */
function around(object: NeutralObject, scene: NeutralScene): readonly NeutralObject[] {
  const others = scene.objects.filter(
    (other) =>
      other !== object &&
      scene.materials[other.material]?.iorInside !== undefined &&
      contains(other, object) &&
      !contains(object, other),
  );
  return others.sort((a, b) => Number(contains(a, b)) - Number(contains(b, a)));
}

interface Ball {
  readonly center: Vec3;
  readonly radius: number;
}

/** Touching from within is within: numbers are rounded to f32. */
const ROUNDING = 2 ** -20;

const contains = (outer: NeutralObject, inner: NeutralObject): boolean => {
  const room = Object.hasOwn(rooms, outer.shape) ? rooms[outer.shape] : undefined;
  const balls = outermost(inner);
  return room !== undefined && balls.length > 0 && balls.every((ball) => room(outer, ball) >= -ROUNDING);
};

/** How far a ball is from the surface, in parts of the size of what it is within; below 0, it reaches out. */
const rooms: { readonly [shape: string]: (outer: NeutralObject, ball: Ball) => number } = {
  sphere(outer, ball) {
    const { center, radius } = given(outer, 'center', 'radius');
    return 1 - (length(subtract(ball.center, center)) + ball.radius) / radius;
  },
  box(outer, ball) {
    const { min, max } = given(outer, 'min', 'max');
    const place = turnedBy(subtract(ball.center, scale(add(min, max), 0.5)), -(outer.rotateYDegrees ?? 0));
    return Math.min(
      ...place.map((x, k) => 1 - (2 * (Math.abs(x) + ball.radius)) / ((max[k] as number) - (min[k] as number))),
    );
  },
  cylinder(outer, ball) {
    const { a, b, radius } = given(outer, 'a', 'b', 'radius');
    const height = length(subtract(b, a));
    const axis = normalize(subtract(b, a));
    const place = subtract(ball.center, a);
    const along = dot(place, axis);
    const beside = length(addScaled(place, axis, -along));
    return Math.min(
      1 - (beside + ball.radius) / radius,
      (along - ball.radius) / height,
      1 - (along + ball.radius) / height,
    );
  },
};

/** Balls, or points, that are within what is convex only if the object is. */
function outermost(object: NeutralObject): readonly Ball[] {
  const { shape, center, radius = 0, a, b } = object;
  if (shape === 'sphere' && center) return [{ center, radius }];
  if (shape === 'box') return cornersOf(object).map((corner) => ({ center: corner, radius: 0 }));
  if (!a || !b) return [];
  const rim = [a, ...(shape === 'cylinder' ? [b] : [])].flatMap((end) => circle(end, subtract(b, a), radius));
  return [...rim, b].map((point) => ({ center: point, radius: 0 }));
}

function cornersOf(box: NeutralObject): readonly Vec3[] {
  const { min, max } = given(box, 'min', 'max');
  const center = scale(add(min, max), 0.5);
  const half = scale(subtract(max, min), 0.5);
  const signs = [-1, 1];
  return signs.flatMap((x) =>
    signs.flatMap((y) =>
      signs.map((z) => add(center, turnedBy([x * half[0], y * half[1], z * half[2]], box.rotateYDegrees ?? 0))),
    ),
  );
}

/** About the vertical, counter-clockwise seen from above. */
function turnedBy([x, y, z]: Vec3, degrees: number): Vec3 {
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [x * cos + z * sin, y, z * cos - x * sin];
}

/** Points around. */
function circle(center: Vec3, axis: Vec3, radius: number): readonly Vec3[] {
  const [x, y] = tangents(normalize(axis));
  return Array.from({ length: 64 }, (_, i) => {
    const angle = (i * Math.PI) / 32;
    return addScaled(addScaled(center, x, radius * Math.cos(angle)), y, radius * Math.sin(angle));
  });
}
