/**
 * The generated part of the shader for scenes of many objects: they are gone through in loops over uniform arrays, and
 * which one a ray met is told by its number. The same functions as in `unrolled-objects.ts`.
 */

import { directKinds } from './light-records.ts';
import { arrayName, structName } from './pack-scene.ts';
import { primitiveOfKind } from './parts.ts';
import { type ShapeKind, shapeKinds } from './primitives/index.ts';
import type { Requirements } from './requirements.ts';
import { isSolid } from './scene-needs.ts';
import type { BlockLayout } from './std140.ts';

/** The objects of one kind, without or with a space of their own. Their numbers begin at `first`. */
interface Group {
  readonly kind: ShapeKind;
  readonly count: number;
  readonly first: number;
  /** The `i`-th of them. */
  readonly shape: string;
  /** The space of the `i`-th, if it has one. */
  readonly place?: string;
}

export function indexedObjects(required: Requirements, scene: BlockLayout): string {
  const groups = objectGroups(required);
  const has = (feature: string): boolean => required.features.some((one) => one === feature);
  return [
    partsGlsl(scene),
    HIT_AND_FROM,
    nearestGlsl(groups),
    has('shadows') ? occlusionGlsl(groups, has('path')) : '',
    surfaceGlsl(groups, has),
    has('path') ? '' : lightsGlsl(required),
  ].join('\n');
}

/** Arrays stay uniforms. GLSL knows no empty struct: without surroundings there is a number in place of them. */
function partsGlsl({ entries }: BlockLayout): string {
  const surroundings = entries.some(({ name }) => name === 'surroundings');
  return `struct Parts {
  ${surroundings ? 'Surroundings surroundings' : 'float none'};
};
Parts loadParts() {
  return Parts(${surroundings ? 'surroundings' : '0.0'});
}
`;
}

const HIT_AND_FROM = `struct Hit {
  float t;
  int object;
};
const Hit NOTHING = Hit(MISS, -1);
struct From {
  vec3 o;
  bool camera;
  Hit own;
};
From fromPoint(Parts scene, vec3 o, Hit own) {
  return From(o, false, own);
}
From fromCamera(Parts scene) {
  return From(vec3(0.0), true, NOTHING);
}
`;

/** 1 for the object that a ray leaves, the `i`-th of its group. */
const own = ({ first }: Group): string => `from.own.object == ${first} + i ? 1.0 : 0.0`;

function objectGroups({ shapes, placed }: Requirements): readonly Group[] {
  let [first, placement] = [0, 0];
  return shapeKinds.flatMap((kind) => {
    const [plain, own] = [shapes[kind], placed[kind]];
    const groups: readonly Group[] = [
      { kind, count: plain, first, shape: element(arrayName(kind), 0) },
      {
        kind,
        count: own,
        first: first + plain,
        shape: element(arrayName(kind), plain),
        place: element('placements', placement),
      },
    ];
    first += plain + own;
    placement += own;
    return groups.filter(({ count }) => count > 0);
  });
}

/** The `i`-th from the `start`-th on. */
const element = (array: string, start: number): string => `${array}[${start > 0 ? `${start} + ` : ''}i]`;

/** A point or a unit direction of the scene, in the space of the group's shapes. */
const ownPoint = ({ place }: Group, point: string): string => (place ? `placedPoint(${place}, ${point})` : point);
const ownDirection = ({ place }: Group, d: string): string => (place ? `placedDirection(${place}, ${d}).xyz` : d);

/** What rays share that start at a point. */
const fromGlsl = (group: Group, point: string): string =>
  `${group.kind}From(${group.shape}, ${ownPoint(group, point)})`;

/** Few of these are written out: software rasterisers read the members of an array twice as fast at a constant place. */
const SHORT_KINDS: readonly ShapeKind[] = ['sphere', 'plane', 'disc', 'quad', 'box', 'triangle'];
const FEW = 8;

/** A body for every object of a group, `i` being its index. */
function loop({ kind, count }: Group, body: string): string {
  if (count > FEW || !SHORT_KINDS.includes(kind)) return `  for (int i = 0; i < ${count}; i++) {\n${body}\n  }`;
  return Array.from({ length: count }, (_, i) => `  {\n    const int i = ${i};\n${body}\n  }`).join('\n');
}

function nearestGlsl(groups: readonly Group[]): string {
  const searches = groups.map((group) => {
    const { kind, shape, place, first } = group;
    const distance = (d: string): string => `${kind}Distance(${shape}, seen, ${d}, ${own(group)})`;
    return loop(
      group,
      `    ${structName(kind)}From seen = ${fromGlsl(group, 'from.o')};
    if (from.camera) seen = ${kind}FromCamera(${shape});
${
  place
    ? `    vec4 e = placedDirection(${place}, d);
    float t = placedDistance(${distance('e.xyz')}, e.w);`
    : `    float t = ${distance('d')};`
}
    if (t < hit.t) hit = Hit(t, ${first} + i);`,
    );
  });
  return `Hit nearest(Parts scene, From from, vec3 d) {
  Hit hit = NOTHING;
${searches.join('\n')}
  return hit;
}
`;
}

/** Paths come to both sides of a plane, and to lights that are objects themselves: those do not stand in their own way. */
function occlusionGlsl(groups: readonly Group[], paths: boolean): string {
  const searches = groups
    .filter(({ kind }) => paths || isSolid(kind))
    .map((group) => {
      const { kind, shape, place, first } = group;
      const other = paths ? `${first} + i != lamp && ` : '';
      const occlusion = (d: string, limit: string): string =>
        `${other}${kind}Occlusion(${shape}, ${fromGlsl(group, 'from.o')}, ${d}, ${limit}, ${own(group)})`;
      return loop(
        group,
        place
          ? `    vec4 e = placedDirection(${place}, d);
    if (${occlusion('e.xyz', 'min(limit * e.w, MISS)')} > 0.0) return 1.0;`
          : `    if (${occlusion('d', 'limit')} > 0.0) return 1.0;`,
      );
    });
  return `float occlusion(Parts scene, From from, vec3 d, float limit${paths ? ', int lamp' : ''}) {
${searches.join('\n')}
  return 0.0;
}
`;
}

/** Statements for the object that the point is on, `i` being its index in the array of its kind. */
function forHit(groups: readonly Group[], statements: (group: Group) => readonly string[]): string {
  const branches = groups.map((group, number) => {
    const last = number === groups.length - 1;
    const condition = last ? '' : `if (from.own.object < ${group.first + group.count}) `;
    const lines = [`int i = from.own.object - ${group.first};`, ...statements(group)];
    return `${condition}{\n    ${lines.join('\n    ')}\n  }`;
  });
  return `  ${branches.join(' else ')}`;
}

/** What a ray met: all of it is asked of the object at once, and its material is read in one place for all kinds. */
function metGlsl(groups: readonly Group[], has: (feature: string) => boolean): string {
  const isCheckered = ({ kind }: Group): boolean => has(`${kind}Checker`);
  const checkered = groups.some(isCheckered);
  const statements = (group: Group): readonly string[] => {
    const { kind, shape, place } = group;
    const normal = `${kind}Normal(s, at, e, 1.0)`;
    return [
      `${structName(kind)} s = ${shape};`,
      `${structName(kind)}From at = ${kind}From(s, ${ownPoint(group, 'from.o')});`,
      `vec3 e = ${ownDirection(group, 'd')};`,
      `met.normal = ${place ? `placedNormal(${place}, ${normal})` : normal};`,
      ...(has('sides') ? [`met.front = ${kind}Front(s, at, e);`] : []),
      'material = s.material;',
      ...(isCheckered(group) ? [`odd = checkerOdd(${kind}Cells(s, ${ownPoint(group, 'from.o')}));`] : []),
    ];
  };
  const map = ({ kind }: Group): readonly string[] =>
    has(`${kind}Map`) ? [`mapImage(met.material, ${kind}Place(unitPoint(met.material, from.o)));`] : [];
  return `struct Met {
  vec3 normal;
${has('sides') ? '  bool front;\n' : ''}  Material material;
};
Met metAt(Parts scene, From from, vec3 d) {
  Met met;
  int material;
${checkered ? '  float odd = 0.0;\n' : ''}${forHit(groups, statements)}
  met.material = materials[material];
${checkered ? '  met.material.color += odd * met.material.checkerStep;\n' : ''}${has('map') ? `${forHit(groups, map)}\n` : ''}  return met;
}
`;
}

function surfaceGlsl(groups: readonly Group[], has: (feature: string) => boolean): string {
  const closed = groups.filter(({ kind }) => primitiveOfKind(kind).closed);
  const isClosed = `bool isClosed(int object) {
  return ${closed.map(({ first, count }) => `(object >= ${first} && object < ${first + count})`).join(' || ')};
}
`;
  return [
    has('map') ? '#include "image-map.glsl"\n' : '',
    has('thin') && has('solid') ? isClosed : '',
    metGlsl(groups, has),
  ].join('');
}

function lightsGlsl({ lights }: Requirements): string {
  const kinds = directKinds.filter((kind) => lights[kind] > 0);
  if (kinds.length === 0) return '';
  const sums = kinds.map(
    (kind) =>
      `  for (int i = 0; i < ${lights[kind]}; i++) {
    light += ${kind}Light(${kind}Lights[i], scene, from, s, p, d);
  }`,
  );
  return `#include "light/lights.glsl"
vec3 lightAt(Parts scene, From from, Surface s, vec3 p, vec3 d) {
  vec3 light = vec3(0.0);
${sums.join('\n')}
  return light;
}
`;
}
