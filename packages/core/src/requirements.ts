/** What a scene requires of its shader, as a value: moving, recolouring or resizing an object does not change it. */

import type { Feature } from './features.ts';
import { pathParts } from './parts.ts';
import { shapeKinds } from './primitives/index.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { isSolid, mergeNeeds, type SceneNeeds, sceneNeeds, type Tracing } from './scene-needs.ts';

export interface Requirements {
  /** What they follow from. */
  readonly needs: SceneNeeds;
  /** The most surfaces that a ray meets. */
  readonly bounces: number;
  /** Places for objects, lights and materials. */
  readonly shapes: SceneNeeds['shapes'];
  readonly placed: SceneNeeds['placed'];
  readonly lights: SceneNeeds['lights'];
  readonly emitters: number;
  readonly materials: number;
  /** In the order of the alphabet. */
  readonly features: readonly Feature[];
}

/** What a resolved scene requires, when light is followed so; the integrator is `direct` where none is given. */
export const requirements = (scene: ResolvedScene, tracing: Tracing): Requirements =>
  derive(sceneNeeds(scene, tracing));

/** What serves both: what was compiled once stays, so that going back and forth compiles nothing. */
export const mergeRequirements = (a: Requirements, b: Requirements): Requirements =>
  derive(mergeNeeds(a.needs, b.needs));

/** Equal for requirements that the same program serves. */
export const requirementsKey = ({ features: present, bounces, ...counts }: Requirements): string => {
  const isEndless = present.includes('reflections') || present.includes('path');
  return JSON.stringify([
    present,
    isEndless ? bounces : 1,
    counts.shapes,
    counts.placed,
    counts.lights,
    counts.emitters,
    counts.materials,
  ]);
};

/**
 * Up to so many spheres and planes (or lights) are written out one by one; more are gone through in loops, and found by
 * number. So are all objects where there are others, or placed ones: those branch, and in `do` loops that branch SwiftShader never ends.
 */
const MOST_UNROLLED = 8;

function derive(needs: SceneNeeds): Requirements {
  const objects = total(needs.shapes) + total(needs.placed);
  const { sphere, plane } = needs.shapes;
  const follows = needs.features.has('path');
  const indexed = follows || objects > sphere + plane || objects > MOST_UNROLLED || total(needs.lights) > MOST_UNROLLED;
  const places = <C extends { readonly [kind: string]: number }>(counts: C): C =>
    (indexed ? Object.fromEntries(Object.entries(counts).map(([kind, n]) => [kind, roundedUp(n)])) : counts) as C;
  const present = follows ? pathParts().features(needs) : directFeatures(needs, indexed);
  return {
    needs,
    bounces: needs.bounces,
    shapes: places(needs.shapes),
    placed: places(needs.placed),
    lights: places(needs.lights),
    emitters: needs.emitters,
    // Objects that are written out one by one have a material each.
    materials: indexed ? roundedUp(Math.max(needs.materials, 1)) : objects,
    features: [...present].sort(),
  };
}

/** Whether any of the shapes has a pattern. */
export const hasChecker = (present: ReadonlySet<Feature>): boolean =>
  shapeKinds.some((kind) => present.has(`${kind}Checker`));

/** What `direct` needs of it, without what the nodes would have brought for nothing. */
function directFeatures(
  { bounces, shapes, placed, lights, features: given }: SceneNeeds,
  indexed: boolean,
): Set<Feature> {
  const present = new Set(given);
  const has = (feature: Feature): boolean => present.has(feature);
  const set = (feature: Feature, needed: boolean): unknown => (needed ? present.add(feature) : present.delete(feature));
  const hasLights = total(lights) > 0;
  // A ray that leaves a torus may meet the same one again.
  const several = total(shapes) + total(placed) > 1 || shapes.torus + placed.torus > 0;
  const solid = shapeKinds.some((kind) => shapes[kind] + placed[kind] > 0 && isSolid(kind));

  set('specular', has('specular') && has('dielectric'));
  const reflective = (hasLights || has('environment')) && (has('metal') || has('specular'));
  set('reflective', reflective);
  set('metal', has('metal') && reflective);
  set('specular', has('specular') && reflective);
  for (const detail of ['specularTint', 'specularWeight'] as const) set(detail, has(detail) && has('specular'));
  set('highlights', reflective && hasLights);
  set('reflections', reflective && (has('environment') || (bounces > 1 && (several || has('inside')))));

  set('checker', hasChecker(present));
  set('turnedChecker', has('turnedChecker') && has('planeChecker'));
  set('mixedFalloff', has('falloff') && has('noFalloff'));
  set('shadows', several && hasLights && solid);
  set('indexed', indexed);
  set('closeSphere', has('closeSphere') || (indexed && shapes.sphere + placed.sphere > 0));
  set('exactRays', indexed || has('wideRange'));
  return present;
}

const total = (counts: { readonly [kind: string]: number }): number =>
  Object.values(counts).reduce((sum, count) => sum + count, 0);

/** How many objects stay in a space of their own. */
export const placedCount = ({ placed }: Pick<Requirements, 'placed'>): number => total(placed);

/** The next power of two: a scene that grows object by object then compiles a few times, not each time. */
const roundedUp = (count: number): number => (count === 0 ? 0 : 2 ** Math.ceil(Math.log2(count)));
