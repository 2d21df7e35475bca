/** Materials at one point, of all sorts, for the tests of both sides. */
import type { Vec3 } from '@ray-scene/core';
import type { Bsdf } from '../../packages/core/src/reference/material/bsdf.ts';
import { scale } from '../../packages/core/src/vector.ts';

const WHITE: Vec3 = [1, 1, 1];

interface Looks {
  readonly color?: Vec3;
  readonly alpha?: number;
  readonly metalness?: number;
  readonly ior?: number;
  readonly specular?: number;
  readonly specularColor?: Vec3;
  readonly transmission?: number;
  readonly thin?: boolean;
  /** Seen from inside. */
  readonly inside?: boolean;
}

/** As a material with such fields gives it. */
export function bsdfOf(looks: Looks): Bsdf {
  const { color = WHITE, alpha = 0.25, metalness = 0, ior = 1.5, specular = 1, specularColor = WHITE } = looks;
  const { transmission = 0, thin = false, inside = false } = looks;
  const straight = ((ior - 1) / (ior + 1)) ** 2;
  const rounded = (x: Vec3): Vec3 => x.map(Math.fround) as unknown as Vec3;
  return {
    color: rounded(color),
    alpha: Math.fround(alpha),
    f0: rounded(specularColor.map((tint) => specular * Math.min(straight * tint, 1)) as unknown as Vec3),
    f90: Math.fround(specular),
    metalness: Math.fround(metalness),
    specular: rounded(scale(specularColor, specular)),
    transmission: Math.fround(transmission),
    eta: Math.fround(inside ? 1 / ior : ior),
    thin,
  };
}

const GOLD: Vec3 = [1, 0.78, 0.34];
const RED: Vec3 = [0.8, 0.1, 0.05];

/** What stands for what may go wrong in a lobe of its own, or where lobes meet. */
export const materials: { readonly [name: string]: Bsdf } = {
  dull: bsdfOf({ color: RED, specular: 0, alpha: 0 }),
  plastic: bsdfOf({ color: RED }),
  'polished plastic': bsdfOf({ color: RED, alpha: 0 }),
  'nearly polished plastic': bsdfOf({ color: RED, alpha: 1e-4 }),
  'rough plastic': bsdfOf({ color: RED, alpha: 1 }),
  'weak reflection': bsdfOf({ color: RED, specular: 0.4, alpha: 0.1 }),
  'tinted reflection': bsdfOf({ color: RED, specularColor: [1, 0.4, 0.2], ior: 2.4, alpha: 0.1 }),
  'white metal': bsdfOf({ metalness: 1 }),
  gold: bsdfOf({ color: GOLD, metalness: 1, alpha: 0.1 }),
  'rough gold': bsdfOf({ color: GOLD, metalness: 1, alpha: 1 }),
  'polished gold': bsdfOf({ color: GOLD, metalness: 1, alpha: 0 }),
  'nearly polished gold': bsdfOf({ color: GOLD, metalness: 1, alpha: 2 ** -30 }),
  'half metal': bsdfOf({ color: GOLD, metalness: 0.5, alpha: 0.2 }),
  glass: bsdfOf({ transmission: 1, alpha: 0 }),
  'glass from inside': bsdfOf({ transmission: 1, alpha: 0, inside: true }),
  'ground glass': bsdfOf({ transmission: 1, alpha: 0.3 }),
  'ground glass from inside': bsdfOf({ transmission: 1, alpha: 0.3, inside: true }),
  'rough glass': bsdfOf({ transmission: 1, alpha: 1 }),
  'nearly polished glass': bsdfOf({ transmission: 1, alpha: 1e-4 }),
  'dense glass': bsdfOf({ transmission: 1, alpha: 0.1, ior: 2.4, inside: true }),
  'thin air': bsdfOf({ transmission: 1, alpha: 0.3, ior: 1.0003 }),
  'what is the same on both sides': bsdfOf({ transmission: 1, alpha: 0.3, ior: 1 }),
  'glass without reflection': bsdfOf({ transmission: 1, alpha: 0.2, specular: 0 }),
  'tinted glass': bsdfOf({ color: RED, transmission: 1, alpha: 0.2, specular: 0.7, specularColor: [1, 0.9, 0.3] }),
  pane: bsdfOf({ transmission: 1, alpha: 0, thin: true }),
  'ground pane': bsdfOf({ color: RED, transmission: 1, alpha: 0.3, thin: true }),
  milk: bsdfOf({ color: RED, transmission: 0.5, alpha: 0.2 }),
  'all at once': bsdfOf({ color: GOLD, transmission: 0.6, metalness: 0.3, specular: 0.8, alpha: 0.2, inside: true }),
};

/** The names that a shader for these materials asks for by `#if`; see `features` of scene-needs.ts. */
export function definedFor(all: readonly Bsdf[]): ReadonlySet<string> {
  const some = (is: (bsdf: Bsdf) => boolean): boolean => all.some(is);
  const dielectrics = all.filter(({ metalness }) => metalness < 1);
  const shines = (bsdf: Bsdf): boolean => bsdf.metalness > 0 || bsdf.f90 > 0 || bsdf.transmission > 0;
  const through = dielectrics.filter(({ transmission }) => transmission > 0);
  const facts: { readonly [name: string]: boolean } = {
    METAL: some(({ metalness }) => metalness > 0),
    DIELECTRIC: dielectrics.length > 0,
    SPECULAR: dielectrics.some(({ f90 }) => f90 > 0),
    SPECULAR_TINT: dielectrics.some(({ specular: [r, g, b] }) => r !== g || g !== b),
    SPECULAR_WEIGHT: dielectrics.some(({ f90 }) => f90 > 0) && dielectrics.some(({ f90 }) => f90 < 1),
    REFLECTIVE: some(shines),
    ROUGH: some((bsdf) => shines(bsdf) && bsdf.alpha > 0),
    SMOOTH: some((bsdf) => shines(bsdf) && bsdf.alpha === 0),
    TRANSMISSION: through.length > 0,
    OPAQUE_BASE: dielectrics.some(({ transmission }) => transmission < 1),
    THIN: through.some(({ thin }) => thin),
    SOLID: through.some(({ thin }) => !thin),
  };
  return new Set(Object.keys(facts).filter((name) => facts[name]));
}
