/**
 * The generated part of the shader for scenes of few objects: every object is written out by itself, and what a ray met
 * is a sum over all of them with weights, 1 for the object that it met and 0 for the others. There is no loop and no
 * table look-up; see `indexed-objects.ts` for the same functions over many objects.
 */

import { directKinds } from './light-records.ts';
import { structName } from './pack-scene.ts';
import { moreParts } from './parts.ts';
import { type ShapeKind, shapeKinds } from './primitives/index.ts';
import type { Requirements } from './requirements.ts';
import { isSolid } from './scene-needs.ts';
import type { BlockLayout } from './std140.ts';

interface Part {
  /** Name in the shader: `sphere0`. */
  readonly name: string;
  readonly kind: ShapeKind;
  /** Number among all objects. */
  readonly number: number;
}

export function unrolledObjects(required: Requirements, scene: BlockLayout, fromRows: boolean): string {
  const parts = objectParts(required);
  const has = (feature: string): boolean => required.features.some((one) => one === feature);
  return [
    partsGlsl(scene, fromRows),
    hitGlsl(parts),
    fromGlsl(parts),
    nearestGlsl(parts),
    has('shadows') ? occlusionGlsl(parts) : '',
    surfaceGlsl(parts, scene, has),
    lightsGlsl(required),
  ].join('\n');
}

function objectParts({ shapes }: Requirements): readonly Part[] {
  let number = 0;
  return shapeKinds.flatMap((kind) =>
    Array.from({ length: shapes[kind] }, (_, i) => ({ name: `${kind}${i}`, kind, number: number++ })),
  );
}

/** `spheres[2]` is called `sphere2` once it is loaded. */
const partName = (array: string, index: number): string => `${array.replace(/s$/, '')}${index}`;

/** All numbers of the scene, read once into one struct. */
function partsGlsl(scene: BlockLayout, fromRows: boolean): string {
  const loaded = scene.entries.flatMap((entry) =>
    Array.from({ length: entry.count ?? 1 }, (_, i) => ({
      type: entry.struct.name,
      name: entry.count === undefined ? entry.name : partName(entry.name, i),
      value: fromRows
        ? moreParts().rows.structFromRows(entry, i)
        : `${entry.name}${entry.count === undefined ? '' : `[${i}]`}`,
    })),
  );
  return `struct Parts {
${loaded.map(({ type, name }) => `  ${type} ${name};`).join('\n')}
};
Parts loadParts() {
  return Parts(${loaded.map(({ value }) => value).join(', ')});
}
`;
}

/** What all rays from one point share, for every object, and which of them the point is on. */
function fromGlsl(parts: readonly Part[]): string {
  return `struct From {
${parts.map(({ name, kind }) => `  ${structName(kind)}From ${name};`).join('\n')}
  Hit own;
};
From fromPoint(Parts scene, vec3 o, Hit own) {
  return From(${parts.map(({ name, kind }) => `${kind}From(scene.${name}, o)`).join(', ')}, own);
}
From fromCamera(Parts scene) {
  return From(${parts.map(({ name, kind }) => `${kind}FromCamera(scene.${name})`).join(', ')}, NOTHING);
}
`;
}

/**
 * A hit tells of each object whether it is one after that: `after1` is 1 if its number is above 1. Weights are differences
 * of these, so they add up to 1 whatever the ties; and a loop keeps one number less, which software rasterisers thank.
 */
function hitGlsl(parts: readonly Part[]): string {
  return `struct Hit {
  float t;
${parts.map(({ number }) => `  float after${number};`).join('\n')}
};
const Hit NOTHING = Hit(MISS${', 1.0'.repeat(parts.length)});
`;
}

function nearestGlsl(parts: readonly Part[]): string {
  const distances = parts.map(
    ({ name, kind, number }) =>
      `  float t${number} = ${kind}Distance(scene.${name}, from.${name}, d, ${weight('from.own', number)});`,
  );
  // From here on t1 is the least of t1, t2, …
  const least = [...parts.slice(0, -1)]
    .reverse()
    .map(({ number }) => `  t${number} = min(t${number}, t${number + 1});`);
  return `Hit nearest(Parts scene, From from, vec3 d) {
${[...distances, ...least].join('\n')}
  return Hit(t0, ${[...parts.slice(1).map(({ number }) => `step(t${number}, t0)`), '0.0'].join(', ')});
}
`;
}

const weight = (hit: string, number: number): string =>
  number === 0 ? `1.0 - ${hit}.after0` : `${hit}.after${number - 1} - ${hit}.after${number}`;

const weightsGlsl = (parts: readonly Part[]): string =>
  parts.map(({ number }) => `  float w${number} = ${weight('from.own', number)};`).join('\n');

function occlusionGlsl(parts: readonly Part[]): string {
  const solids = parts.filter(({ kind }) => isSolid(kind));
  const occlusions = solids.map(
    ({ name, kind, number }) =>
      `${kind}Occlusion(scene.${name}, from.${name}, d, limit, ${weight('from.own', number)})`,
  );
  return `float occlusion(Parts scene, From from, vec3 d, float limit) {
  return ${occlusions.reduce((a, b) => `max(${a}, ${b})`)};
}
`;
}

/** A sum over objects, each times its weight. */
const weighted = (parts: readonly Part[], term: (part: Part) => string): string =>
  parts.map((part) => `w${part.number} * ${term(part)}`).join(' + ');

function surfaceGlsl(parts: readonly Part[], scene: BlockLayout, has: (feature: string) => boolean): string {
  const struct = scene.entries.find(({ name }) => name === 'materials')?.struct;
  const members = (struct?.members ?? [])
    .filter(({ name }) => name !== 'checkerStep')
    .map(({ name }) => `  m.${name} = ${weighted(parts, ({ number }) => `scene.material${number}.${name}`)};\n`);
  const normals = parts.map(({ name, kind, number }) => `${kind}Normal(scene.${name}, from.${name}, d, w${number})`);
  return `vec3 normalAt(Parts scene, From from, vec3 d) {
${weightsGlsl(parts)}
  return ${normals.join(' + ')};
}
Material materialAt(Parts scene, From from, vec3 p) {
${weightsGlsl(parts)}
  Material m;
${members.join('')}${checkerGlsl(parts.filter(({ kind }) => has(`${kind}Checker`)))}  return m;
}
`;
}

/** What the checkers of the objects that may have one add to the colour. */
function checkerGlsl(checkered: readonly Part[]): string {
  const cells = ({ name, kind }: Part): string => `${kind}Cells(scene.${name}, p)`;
  const step = ({ number }: Part): string => `scene.material${number}.checkerStep`;
  const [only, ...others] = checkered;
  if (!only) return '';
  return others.length === 0
    ? `  m.color += (w${only.number} * checkerOdd(${cells(only)})) * ${step(only)};\n`
    : `  m.color += checkerOdd(${weighted(checkered, cells)}) * (${weighted(checkered, step)});\n`;
}

/** The light of all lights that a surface sends along -d. */
function lightsGlsl({ lights }: Requirements): string {
  const terms = directKinds.flatMap((kind) =>
    Array.from({ length: lights[kind] }, (_, i) => `${kind}Light(scene.${kind}Light${i}, scene, from, s, p, d)`),
  );
  if (terms.length === 0) return '';
  return `#include "light/lights.glsl"
vec3 lightAt(Parts scene, From from, Surface s, vec3 p, vec3 d) {
  return ${terms.join(' + ')};
}
`;
}
