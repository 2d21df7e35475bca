/** Questions to BSDFs, with numbers that are exact in f32. */
import type { Vec3 } from '@ray-scene/core';
import type { Bsdf } from '../../packages/core/src/reference/material/bsdf.ts';
import { normalize } from '../../packages/core/src/vector.ts';
import { bsdfOf } from './cases.ts';

/** What is asked: a sample for wo, u and lobe, and the value for wo and wi. */
export interface Question {
  readonly wo: Vec3;
  readonly u: readonly [number, number];
  readonly lobe: number;
  readonly wi: Vec3;
}

/** The last number before 1 that a sampler gives. */
export const NEARLY_1 = 1 - 2 ** -24;

export const rounded = (v: Vec3): Vec3 => v.map(Math.fround) as unknown as Vec3;

/** Evenly over the hemisphere, or (grazing) with all magnitudes of z. */
export function direction(random: () => number, isGrazing: boolean): Vec3 {
  const z = isGrazing ? 10 ** (-7 * random()) : random();
  const angle = 2 * Math.PI * random();
  const r = Math.sqrt(1 - z * z);
  return rounded(normalize([r * Math.cos(angle), r * Math.sin(angle), z]));
}

/** At the ends of all ranges more often than not. */
export function anyMaterial(random: () => number): Bsdf {
  const pick = <T>(choices: readonly T[]): T => choices[Math.floor(random() * choices.length)] as T;
  const colour = (): Vec3 => [pick([0, 1, random()]), pick([0, 1, random()]), pick([0, 1, random()])];
  return bsdfOf({
    color: colour(),
    alpha: pick([0, 2 ** -32, 2 ** (-32 * random()), 1]),
    metalness: pick([0, 0, random(), 1]),
    ior: pick([1, 1 + 2 ** -22, 1 + random() ** 8, 1 + random(), 100]),
    specular: pick([0, random(), 1]),
    specularColor: colour(),
    transmission: pick([0, random(), 1]),
    thin: random() < 0.3,
    inside: random() < 0.5,
  });
}

export function anyQuestion(random: () => number): Question {
  const number = (): number => [0, NEARLY_1, random(), random() ** 8][Math.floor(4 * random())] as number;
  const wo = direction(random, random() < 0.5);
  const wi = direction(random, random() < 0.5);
  const [x, y, z] = wo;
  const other: readonly Vec3[] = [wo, [-x, -y, z], [-x, -y, -z], [x, y, -z], wi, [wi[0], wi[1], -wi[2]]];
  return { wo, u: [number(), number()], lobe: number(), wi: other[Math.floor(6 * random())] as Vec3 };
}
