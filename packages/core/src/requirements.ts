/** What a scene requires of its shader, as a value: moving, recolouring or resizing an object does not change it. */
import type { Field } from './fields.ts';
import { primitiveOf, primitives, type ShapeKind, shapeKinds } from './primitives/index.ts';
import { planeAxes } from './primitives/plane.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { type LightKind, lightKinds, lights, material, type Shape } from './schema.ts';

/** Everything that a shader may or may not hold. In GLSL, each is a name to ask for by `#if`. */
export const features = [
  'metal',
  'dielectric',
  'specular',
  'specularTint',
  'specularWeight',
  'falloff',
  'noFalloff',
  'sphereChecker',
  'planeChecker',
  'tiltedPlane',
  'turnedChecker',
  // Derived from the whole scene:
  'mixedFalloff',
  'checker',
  'reflective',
  'highlights',
  'reflections',
  'severalLights',
  'shadows',
  'inside',
  'closeUp',
  'indexed',
  'environment',
  'gradient',
  'backgroundColor',
  'backgroundEnvironment',
] as const;

export type Feature = (typeof features)[number];

export interface Requirements {
  /** The most surfaces that a ray meets. */
  readonly bounces: number;
  readonly shapes: { readonly [K in ShapeKind]: number };
  readonly lights: { readonly [K in LightKind]: number };
  readonly materials: number;
  /** In the order of `features`. */
  readonly features: readonly Feature[];
}

/** Up to so many objects (or lights) are written out one by one; more are gone through in loops, and found again by number. */
const MOST_UNROLLED = 8;

/** Whether U runs along x and V along -z, as on a floor whose tangent is left out. */
function isAlongAxes(plane: Shape<'plane'>): boolean {
  const { tangent, bitangent } = planeAxes(plane);
  return tangent[0] === 1 && bitangent[2] === -1;
}

/** Whether a kind can stand between two points outside of it. */
const isSolid = (kind: ShapeKind): boolean => primitives[kind].occludes(1);

/** How much larger than another object a sphere may be before f32 cannot tell where on it that object stands. */
const CLOSE_UP = 2 ** 10;

/** Whether small things lie about on a sphere as large as a planet. */
function isCloseUp({ objects }: ResolvedScene): boolean {
  const radii = objects.flatMap(({ shape }) => (shape.type === 'sphere' ? [(shape as Shape<'sphere'>).radius] : []));
  return Math.max(...radii) >= CLOSE_UP * Math.min(...radii);
}

/** What a resolved scene requires, when rays may meet up to `bounces` surfaces. */
export function requirements(scene: ResolvedScene, { bounces }: { readonly bounces: number }): Requirements {
  const present = new Set<string>([...nodeFeatures(scene), ...checkers(scene)]);
  const has = (feature: Feature): boolean => present.has(feature);
  const add = (feature: Feature, needed: boolean): unknown => needed && present.add(feature);
  const isLit = scene.lights.length > 0 || !!scene.environment;
  if (!has('dielectric')) present.delete('specular');
  const reflective = isLit && (has('metal') || has('specular'));
  if (!reflective) for (const feature of ['metal', 'specular']) present.delete(feature);
  if (!has('specular')) for (const detail of ['specularTint', 'specularWeight']) present.delete(detail);

  add('mixedFalloff', has('falloff') && has('noFalloff'));
  add(
    'checker',
    scene.objects.some((object) => scene.materials[object.material]?.checker),
  );
  const inside = scene.objects.some(
    ({ shape }) => isSolid(shape.type) && primitiveOf(shape).side(shape, scene.camera.position) < 0,
  );
  const indexed = scene.objects.length > MOST_UNROLLED || scene.lights.length > MOST_UNROLLED;
  const rounded = (count: number): number => (indexed ? roundedUp(count) : count);
  const severalObjects = scene.objects.length > 1;
  const planes = scene.objects.map(({ shape }) => shape).filter((shape) => shape.type === 'plane') as Shape<'plane'>[];
  add(
    'tiltedPlane',
    planes.some((plane) => Math.abs(planeAxes(plane).normal[1]) !== 1),
  );
  add('turnedChecker', has('planeChecker') && planes.some((plane) => !isAlongAxes(plane)));
  add('reflective', reflective);
  add('highlights', reflective && scene.lights.length > 0);
  add('shadows', severalObjects && scene.lights.length > 0 && scene.objects.some(({ shape }) => isSolid(shape.type)));
  add('inside', inside);
  add('closeUp', isCloseUp(scene));
  add('severalLights', indexed || scene.lights.length > 1);
  add('indexed', indexed);
  add('reflections', reflective && (!!scene.environment || (bounces > 1 && (severalObjects || inside))));
  add('environment', !!scene.environment);
  add('gradient', scene.environment?.kind === 'gradient');
  add('backgroundEnvironment', scene.background === 'environment' && !!scene.environment);
  add(
    'backgroundColor',
    typeof scene.background !== 'string' || (scene.background === 'environment' && !scene.environment),
  );
  return {
    bounces,
    shapes: counts(shapeKinds, kindsOrNone(scene), rounded),
    lights: counts(
      lightKinds,
      scene.lights.map(({ type }) => type),
      rounded,
    ),
    materials: indexed ? rounded(scene.materials.length) : kindsOrNone(scene).length,
    features: features.filter(has),
  };
}

/** The kinds of all objects. GLSL knows no empty struct, so a scene without objects holds the place of one. */
const kindsOrNone = ({ objects }: ResolvedScene): readonly ShapeKind[] =>
  objects.length > 0 ? objects.map(({ shape }) => shape.type) : ['sphere'];

/** What serves both: features that were compiled once stay, so that going back and forth compiles nothing. */
export function mergeRequirements(a: Requirements, b: Requirements): Requirements {
  const largest = <K extends string>(x: { readonly [P in K]: number }, y: { readonly [P in K]: number }) =>
    Object.fromEntries(Object.keys(x).map((kind) => [kind, Math.max(x[kind as K], y[kind as K])])) as {
      [P in K]: number;
    };
  const shapes = largest(a.shapes, b.shapes);
  // Of what is behind the objects there is but one.
  const stays = (feature: Feature): boolean => !feature.startsWith('background') && a.features.includes(feature);
  const together = features.filter((feature) => b.features.includes(feature) || stays(feature));
  return {
    bounces: b.bounces,
    shapes,
    lights: largest(a.lights, b.lights),
    // Objects that are written out one by one have a material each.
    materials: together.includes('indexed')
      ? Math.max(a.materials, b.materials)
      : shapeKinds.reduce((sum, kind) => sum + shapes[kind], 0),
    features: together,
  };
}

/** Equal for requirements that the same program serves. */
export const requirementsKey = (required: Requirements): string =>
  JSON.stringify({ ...required, bounces: required.features.includes('reflections') ? required.bounces : 1 });

/** The features that the table of fields names for the values of this scene. */
function nodeFeatures({ lights: nodes, materials }: ResolvedScene): string[] {
  return [
    ...nodes.flatMap((node) => switchedOn(lights[node.type].fields, node)),
    ...materials.flatMap((node) => switchedOn(material.fields, node)),
  ];
}

function switchedOn(fields: { readonly [name: string]: Field<unknown> }, node: object): string[] {
  return Object.entries(fields).flatMap(([name, field]) => {
    const value = (node as { readonly [name: string]: unknown })[name];
    return value === undefined || value === null ? [] : [...field.features(value)];
  });
}

const checkers = ({ objects, materials }: ResolvedScene): Feature[] =>
  objects.filter((object) => materials[object.material]?.checker).map(({ shape }) => `${shape.type}Checker` as const);

function counts<K extends string>(
  kinds: readonly K[],
  found: readonly K[],
  rounded = (count: number) => count,
): { readonly [P in K]: number } {
  return Object.fromEntries(kinds.map((kind) => [kind, rounded(found.filter((one) => one === kind).length)])) as {
    [P in K]: number;
  };
}

/** The next power of two: a scene that grows object by object then compiles a few times, not each time. */
const roundedUp = (count: number): number => (count === 0 ? 0 : 2 ** Math.ceil(Math.log2(count)));
