/** Scenes as people build them, at random: a few shapes of all kinds before a camera, with lamps and a sky. */
import { type ShapeKind, shapeKinds } from '@ray-scene/core';
import { hash } from '../../packages/core/src/random.ts';

type Json = { readonly [key: string]: unknown };
type Triple = readonly [number, number, number];

/** Numbers from a seed: as many as are asked for, the same each time. */
class Dice {
  #state: number;

  constructor(seed: number) {
    this.#state = hash(seed);
  }

  /** From low to high, with six digits, as in a file. */
  between(low: number, high: number): number {
    this.#state = hash(this.#state + 1);
    return Number((low + (high - low) * this.#state * 2 ** -32).toPrecision(6));
  }

  chance(share: number): boolean {
    return this.between(0, 1) < share;
  }

  /** Within a cube around the origin. */
  place(reach: number): Triple {
    return [this.between(-reach, reach), this.between(-reach, reach), this.between(-reach, reach)];
  }

  oneOf<T>(choices: readonly T[]): T {
    return choices[Math.floor(this.between(0, 0.999999) * choices.length)] as T;
  }
}

const plus = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

const shapes: { readonly [K in ShapeKind]: (dice: Dice) => Json } = {
  sphere: (dice) => ({ center: dice.place(2), radius: dice.between(0.1, 1.2) }),
  plane: (dice) => ({ point: [0, dice.between(-3, -1.5), 0], normal: plus([0, 3, 0], dice.place(1)) }),
  disc: (dice) => ({ center: dice.place(2), normal: dice.place(1), radius: dice.between(0.2, 1.5) }),
  quad: (dice) => ({ corner: dice.place(2), edgeU: dice.place(1.5), edgeV: dice.place(1.5) }),
  box: (dice) => ({ center: dice.place(2), size: plus([0.9, 0.9, 0.9], dice.place(0.8)) }),
  cylinder: (dice) => {
    const base = dice.place(2);
    return { base, top: plus(base, dice.place(1.5)), radius: dice.between(0.1, 0.8) };
  },
  cone: (dice) => {
    const base = dice.place(2);
    return { base, tip: plus(base, dice.place(1.5)), radius: dice.between(0.1, 0.8) };
  },
  torus: (dice) => {
    const radius = dice.between(0.3, 1);
    return { center: dice.place(2), axis: dice.place(1), radius, tube: radius * dice.between(0.1, 0.8) };
  },
  triangle: (dice) => ({ a: dice.place(2), b: dice.place(2), c: dice.place(2) }),
};

const color = (dice: Dice): Triple => [dice.between(0.1, 1), dice.between(0.1, 1), dice.between(0.1, 1)];

const surface = (dice: Dice): Json => ({
  color: color(dice),
  metalness: dice.oneOf([0, 0, 0.5, 1]),
  roughness: dice.between(0.2, 1),
  specular: dice.oneOf([0, 1]),
  ...(dice.chance(0.2) ? { checker: color(dice), checkerSize: dice.between(0.2, 1) } : {}),
});

const light = (dice: Dice): Json =>
  dice.chance(0.5)
    ? { type: 'directional', direction: plus([0, -2, 0], dice.place(1.5)), intensity: dice.between(0.5, 3) }
    : { type: 'point', position: plus([0, 4, 2], dice.place(2)), intensity: dice.between(10, 90) };

const listOf = <T>(count: number, make: () => T): readonly T[] => Array.from({ length: Math.floor(count) }, make);

const shape = (dice: Dice): Json => {
  const type = dice.oneOf(shapeKinds);
  return { type, ...shapes[type](dice), ...surface(dice) };
};

/** One or two shapes, moved, turned, and often stretched or mirrored; once in a while in a group of their own. */
const group = (dice: Dice): Json => ({
  type: 'group',
  position: dice.place(0.7),
  rotation: dice.chance(0.7) ? dice.place(180) : [0, dice.oneOf([0, 90, 180]), 0],
  scale: dice.chance(0.4)
    ? dice.between(0.5, 1.5)
    : [dice.between(0.5, 1.5), dice.between(0.5, 1.5), dice.oneOf([-1, 1])],
  objects: listOf(dice.between(1, 2.99), () => (dice.chance(0.2) ? group(dice) : shape(dice))),
});

/** A scene file; the same one for the same seed. */
export function randomScene(seed: number): Json {
  const dice = new Dice(seed);
  return {
    version: 1,
    camera: { position: plus([0, 2, 6], dice.place(2)), target: dice.place(0.5), fov: dice.between(20, 80) },
    lights: listOf(dice.between(1, 3.99), () => light(dice)),
    ...(dice.chance(0.5) ? { environment: { top: color(dice), bottom: color(dice) } } : {}),
    objects: listOf(dice.between(1, 12.99), () => (dice.chance(0.2) ? group(dice) : shape(dice))),
  };
}
