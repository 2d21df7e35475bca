/**
 * The generated part of the shader for scenes of few objects: every object is written out by itself, and which one a ray
 * met is told by weights, 1 for that one and 0 for the others. There is no loop and no table look-up; see
 * `indexed-objects.ts` for the same functions over many objects.
 */
import { structName } from './pack-scene.ts';
import { primitives, type ShapeKind, shapeKinds } from './primitives/index.ts';
import type { Requirements } from './requirements.ts';
import { lightKinds } from './schema.ts';
import type { BlockLayout } from './std140.ts';
import { structFromRows } from './varying-rows.ts';

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
      value: fromRows ? structFromRows(scene, entry, i) : `${entry.name}${entry.count === undefined ? '' : `[${i}]`}`,
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

/** What all rays from one point share, for every object. */
function fromGlsl(parts: readonly Part[]): string {
  return `struct From {
${parts.map(({ name, kind }) => `  ${structName(kind)}From ${name};`).join('\n')}
};
From fromPoint(Parts scene, vec3 o) {
  return From(${parts.map(({ name, kind }) => `${kind}From(scene.${name}, o)`).join(', ')});
}
From fromCamera(Parts scene) {
  return From(${parts.map(({ name, kind }) => `${kind}FromCamera(scene.${name})`).join(', ')});
}
`;
}

function nearestGlsl(parts: readonly Part[]): string {
  const weights = parts.map(({ number }) => `w${number}`);
  const distances = parts.map(
    ({ name, kind, number }) =>
      `  float t${number} = ${kind}Distance(scene.${name}, from.${name}, d, left.w${number});`,
  );
  // Where two are equally near the first takes it all: the weights add up to 1, whatever the ties.
  const exclusive = parts.map(({ number }) =>
    number === parts.length - 1
      ? `  hit.w${number} = rest;`
      : `  hit.w${number} = min(step(t${number}, hit.t), rest);\n  rest -= hit.w${number};`,
  );
  return `struct Hit {
  float t;
${weights.map((w) => `  float ${w};`).join('\n')}
};
const Hit NOTHING = Hit(MISS${', 0.0'.repeat(parts.length)});
Hit nearest(Parts scene, From from, vec3 d, Hit left) {
${distances.join('\n')}
  Hit hit;
  hit.t = ${parts.map(({ number }) => `t${number}`).reduce((a, b) => `min(${a}, ${b})`)};
  float rest = 1.0;
${exclusive.join('\n')}
  return hit;
}
`;
}

function occlusionGlsl(parts: readonly Part[]): string {
  const solids = parts.filter(({ kind }) => primitives[kind].occludes(1));
  const occlusions = solids.map(({ name, kind }) => `${kind}Occlusion(scene.${name}, from.${name}, d, limit)`);
  return `float occlusion(Parts scene, From from, vec3 d, float limit) {
  return ${occlusions.reduce((a, b) => `max(${a}, ${b})`)};
}
`;
}

/** A sum over objects, each times its weight. */
const weighted = (parts: readonly Part[], term: (part: Part) => string): string =>
  parts.map((part) => `hit.w${part.number} * ${term(part)}`).join(' + ');

function surfaceGlsl(parts: readonly Part[], scene: BlockLayout, has: (feature: string) => boolean): string {
  const struct = scene.entries.find(({ name }) => name === 'materials')?.struct;
  const checkered = parts.filter(({ kind }) => has(`${kind}Checker`));
  const members = (struct?.members ?? []).map(({ name: member }) => {
    const among = member === 'checkerStep' ? checkered : parts;
    return `  m.${member} = ${weighted(among, ({ number }) => `scene.material${number}.${member}`)};`;
  });
  // Other objects take no step, wherever they would be in the pattern of the only one that has any.
  const [only, ...others] = checkered.map(({ name, kind, number }) => ({
    number,
    cells: `${kind}Cells(scene.${name}, p)`,
  }));
  const cells =
    others.length === 0
      ? only?.cells
      : [only, ...others].map((one) => `hit.w${one?.number} * ${one?.cells}`).join(' + ');
  return `vec3 normalAt(Parts scene, From from, Hit hit) {
  return ${parts.map(({ name, kind, number }) => `${kind}Normal(scene.${name}, from.${name}, hit.w${number})`).join(' + ')};
}
Material materialAt(Parts scene, Hit hit, vec3 p) {
  Material m;
${members.join('\n')}
${checkered.length > 0 ? `  m.color += checkerOdd(${cells}) * m.checkerStep;\n` : ''}  return m;
}
`;
}

/** The light of all lights that a surface sends along -d. */
function lightsGlsl({ lights }: Requirements): string {
  const terms = lightKinds.flatMap((kind) =>
    Array.from({ length: lights[kind] }, (_, i) => `${kind}Light(scene.${kind}Light${i}, scene, from, s, p, d)`),
  );
  if (terms.length === 0) return '';
  const sum = terms.reduce((before, term) => `both(${before}, ${term})`);
  return `#include "light/lights.glsl"
Lit lightAt(Parts scene, From from, Surface s, vec3 p, vec3 d) {
  return ${sum};
}
`;
}
