/** What a scene requires of its shader, as a value: moving, recolouring or resizing an object does not change it. */
import type { Field } from './fields.ts';
import { primitives, type ShapeKind, shapeKinds } from './primitives/index.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { type LightKind, lightKinds, lights, material } from './schema.ts';

/** Everything that a shader may or may not hold. In GLSL, each is a name to ask for by `#if`. */
export const features = [
  'metal',
  'dielectric',
  'specular',
  'specularTint',
  'falloff',
  'noFalloff',
  'sphereChecker',
  'planeChecker',
  // Derived from the whole scene:
  'mixedFalloff',
  'checker',
  'highlights',
  'reflections',
  'shadows',
  'twoSided',
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

/** What a resolved scene requires, when rays may meet up to `bounces` surfaces. */
export function requirements(scene: ResolvedScene, { bounces }: { readonly bounces: number }): Requirements {
  const present = new Set<string>([...nodeFeatures(scene), ...checkers(scene)]);
  const has = (feature: Feature): boolean => present.has(feature);
  const add = (feature: Feature, needed: boolean): unknown => needed && present.add(feature);
  if (!has('dielectric')) present.delete('specular');
  if (!has('specular')) present.delete('specularTint');

  add('mixedFalloff', has('falloff') && has('noFalloff'));
  add(
    'checker',
    scene.objects.some((object) => scene.materials[object.material]?.checker),
  );
  const reflective = has('metal') || has('specular');
  const shadows = needsShadows(scene);
  add('highlights', reflective && scene.lights.length > 0);
  add('shadows', shadows);
  add('twoSided', shadows || scene.objects.some(({ shape }) => primitives[shape.type].shadowsItself === 'never'));
  add('reflections', reflective && bounces > 1 && (shadows || scene.objects.length > 1 || !!scene.environment));
  add('environment', !!scene.environment);
  add('gradient', scene.environment?.kind === 'gradient');
  add('backgroundEnvironment', scene.background === 'environment' && !!scene.environment);
  add(
    'backgroundColor',
    typeof scene.background !== 'string' || (scene.background === 'environment' && !scene.environment),
  );
  return {
    bounces: has('reflections') ? bounces : 1,
    shapes: counts(
      shapeKinds,
      scene.objects.map(({ shape }) => shape.type),
    ),
    lights: counts(
      lightKinds,
      scene.lights.map(({ type }) => type),
    ),
    materials: scene.materials.length,
    features: features.filter(has),
  };
}

/** What serves both: features that were compiled once stay, so that going back and forth compiles nothing. */
export function mergeRequirements(a: Requirements, b: Requirements): Requirements {
  const largest = <K extends string>(x: { readonly [P in K]: number }, y: { readonly [P in K]: number }) =>
    Object.fromEntries(Object.keys(x).map((kind) => [kind, Math.max(x[kind as K], y[kind as K])])) as {
      [P in K]: number;
    };
  return {
    bounces: b.bounces,
    shapes: largest(a.shapes, b.shapes),
    lights: largest(a.lights, b.lights),
    materials: Math.max(a.materials, b.materials),
    features: features.filter((feature) => a.features.includes(feature) || b.features.includes(feature)),
  };
}

/** Equal for equal requirements: the key of a program. */
export const requirementsKey = (required: Requirements): string => JSON.stringify(required);

/** The features that the table of fields names for the values of this scene. */
function nodeFeatures({ lights: nodes, materials }: ResolvedScene): string[] {
  return [
    ...nodes.flatMap((node) => switchedOn(lights[node.type].fields, node)),
    ...materials.flatMap((node) => switchedOn(material.fields, node)),
  ];
}

function switchedOn(fields: { readonly [name: string]: Field<unknown> }, node: object): string[] {
  return Object.entries(fields).flatMap(([name, field]) => {
    const value = (node as { readonly [name: string]: {} | undefined })[name];
    return value === undefined ? [] : [...field.features(value)];
  });
}

const checkers = ({ objects, materials }: ResolvedScene): Feature[] =>
  objects.filter((object) => materials[object.material]?.checker).map(({ shape }) => `${shape.type}Checker` as const);

/**
 * One flat shape, or one convex solid lit from outside, casts no shadow on a side that is lit: the shader then lights
 * only what faces both the light and the eye.
 */
function needsShadows({ objects, lights: nodes }: ResolvedScene): boolean {
  const [only, ...others] = objects;
  if (!only || nodes.length === 0) return false;
  if (others.length > 0) return true;
  return primitives[only.shape.type].shadowsItself === 'inside' && nodes.some(({ type }) => type === 'point');
}

function counts<K extends string>(kinds: readonly K[], found: readonly K[]): { readonly [P in K]: number } {
  return Object.fromEntries(kinds.map((kind) => [kind, found.filter((one) => one === kind).length])) as {
    [P in K]: number;
  };
}
