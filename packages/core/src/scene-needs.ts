/** What the nodes of a scene need by themselves, before it is asked what follows from all of them together. */
import { NARROW_FOV } from './camera-frame.ts';
import type { Feature } from './features.ts';
import type { Field } from './fields.ts';
import { type DirectKind, directKinds } from './light-records.ts';
import { loadedPaths, pathParts, primitiveOf, primitiveOfKind } from './parts.ts';
import { type ShapeKind, shapeKinds } from './primitives/index.ts';
import { planeAxes } from './primitives/plane.ts';
import { isEmissive, type ResolvedScene } from './resolve-scene.ts';
import { lights, material, type Shape } from './schema.ts';
import type { RenderSettings } from './settings.ts';
import { length, subtract, type Vec3 } from './vector.ts';

/** How light is followed: what of the settings bears on the shader. */
export type Tracing = Pick<RenderSettings, 'bounces'> &
  Partial<Pick<RenderSettings, 'integrator' | 'output' | 'clamp'>>;

export interface SceneNeeds {
  /** The most surfaces that a ray meets. */
  readonly bounces: number;
  readonly shapes: { readonly [K in ShapeKind]: number };
  /** Those that stay in a space of their own are counted by themselves. */
  readonly placed: { readonly [K in ShapeKind]: number };
  /** For the integrator `direct`, and for `path`. */
  readonly lights: { readonly [K in DirectKind]: number };
  readonly emitters: number;
  /** Different ones. */
  readonly materials: number;
  /** Those that follow from nothing else. */
  readonly features: ReadonlySet<Feature>;
}

/** The needs of a scene, when rays may meet up to `bounces` surfaces. */
export function sceneNeeds(scene: ResolvedScene, tracing: Tracing): SceneNeeds {
  const { bounces, integrator, output } = tracing;
  const paths = followsPaths(scene, tracing) ? pathParts().needs(scene, tracing) : undefined;
  const { environment, background } = scene;
  const isImage = environment?.kind === 'image';
  const isShown = background === 'environment';
  const facts: { readonly [F in Feature]?: boolean } = {
    inside: scene.objects.some(
      ({ shape }) => isSolid(shape.type) && primitiveOf(shape).side(shape, scene.camera.position) < 0,
    ),
    closeSphere: isCloseToSphere(scene),
    wideRange: hasWideRange(scene),
    tiltedPlane: shapesOf(scene.objects, 'plane').some((plane) => Math.abs(planeAxes(plane).normal[1]) !== 1),
    turnedChecker: shapesOf(scene.objects, 'plane').some((plane) => !isAlongAxes(plane)),
    environment: !!environment && !isImage,
    gradient: environment?.kind === 'gradient',
    backgroundEnvironment: isShown && !!environment && !isImage,
    // On top of black.
    backgroundImage: isShown && isImage,
    path: !!paths,
    whitted: !!paths && integrator === 'direct',
    backgroundColor: typeof background !== 'string' || (isShown && (!environment || isImage)),
  };
  const present = [
    ...nodeFeatures(scene),
    ...checkers(scene),
    ...(paths?.features ?? []),
    ...views.filter((view) => view === output),
  ];
  return {
    bounces,
    // GLSL knows no empty struct, so a scene without objects holds the place of one.
    shapes: counts(shapeKinds, scene.objects.length > 0 ? kindsOf(scene, false) : ['sphere']),
    placed: counts(shapeKinds, kindsOf(scene, true)),
    lights: counts(directKinds, paths ? [] : (scene.lights.map(({ type }) => type) as DirectKind[])),
    emitters: paths?.emitters ?? 0,
    materials: scene.materials.length,
    features: new Set([...present, ...Object.keys(facts).filter((fact) => facts[fact as Feature])] as Feature[]),
  };
}

/** What serves both. Of what is behind the objects there is but one: that of the second. */
export function mergeNeeds(a: SceneNeeds, b: SceneNeeds): SceneNeeds {
  const changed = (feature: Feature): boolean => a.features.has(feature) !== b.features.has(feature);
  // A shader that reads an image needs one.
  if ((['path', 'whitted', 'imageEmitter', 'map'] as const).some(changed)) return b;
  const stays = [...a.features].filter((feature) => !feature.startsWith('background') && !views.includes(feature));
  return {
    bounces: b.bounces,
    shapes: largest(a.shapes, b.shapes),
    placed: largest(a.placed, b.placed),
    lights: largest(a.lights, b.lights),
    emitters: Math.max(a.emitters, b.emitters),
    materials: Math.max(a.materials, b.materials),
    features: new Set([...b.features, ...stays]),
  };
}

/** What outputs show of surfaces. */
const surfaceOutputs: readonly string[] = ['normal', 'depth', 'albedo'];

/** Kinds of cameras and of what they show: of them, too, there is but one. */
const views: readonly string[] = ['lens', 'distant', ...surfaceOutputs];

/** Whether an output shows what surfaces are like, as opposed to their light and the noise of that. */
export const isSurfaceOutput = (output?: string): boolean => surfaceOutputs.includes(`${output}`);

/**
 * Whether an integrator goes through the scene path by path: `direct` does only where light comes from more than points
 * or goes through surfaces, or the camera is more than a pinhole. What shows surfaces comes with paths, too.
 */
export const followsPaths = (scene: ResolvedScene, { integrator, output }: Partial<Tracing>): boolean =>
  integrator === 'path' || isSurfaceOutput(output) || !isPlain(scene);

function isPlain({ camera, environment, lights: nodes, materials, objects }: ResolvedScene): boolean {
  return (
    camera.type !== 'orthographic' &&
    camera.fov >= NARROW_FOV &&
    !camera.aperture &&
    environment?.kind !== 'image' &&
    // From within a surface, both of its sides are seen.
    objects.every(({ shape }) => primitiveOf(shape).clearance(shape, camera.position) > 0) &&
    nodes.every((light) =>
      light.type === 'directional' ? !light.angularDiameter : light.type === 'point' && !light.radius,
    ) &&
    materials.every((one) => !one.transmission && !one.map && !isEmissive(one))
  );
}

/** Whether a kind can stand between two points outside of it. */
export const isSolid = (kind: ShapeKind): boolean => primitiveOfKind(kind).occludes(1);

const shapesOf = <K extends ShapeKind>(objects: ResolvedScene['objects'], kind: K): readonly Shape<K>[] =>
  objects.map(({ shape }) => shape).filter(({ type }) => type === kind) as unknown as Shape<K>[];

/** Whether U runs along x and V along -z, as on a floor whose tangent is left out. */
function isAlongAxes(plane: Shape<'plane'>): boolean {
  const { tangent, bitangent } = planeAxes(plane);
  return tangent[0] === 1 && bitangent[2] === -1;
}

/** Whether a ray from the camera may meet a sphere where the centre is less than a radius ahead. */
const isCloseToSphere = ({ objects, camera }: ResolvedScene): boolean =>
  shapesOf(objects, 'sphere').some(
    ({ center, radius }) => length(subtract(center, camera.position)) < Math.SQRT2 * radius,
  );

/** The origin of the space that a scene is packed in. Cameras that are far away belong to paths. */
export const frameOrigin = (scene: ResolvedScene): Vec3 => loadedPaths()?.origin(scene) ?? scene.camera.position;

/** How much longer than another a length may be before f32 needs positions in two words. */
const WIDE_RANGE = 2 ** 10;

/** How much nearer than it is large the camera may come to an object before f32 does not know how far it is away. */
const CLOSE_UP = 2 ** 12;

/**
 * Whether lengths differ so much that positions in f32 are not enough: small things on something as large as a planet, a
 * camera close to the surface of one, or one that looks from very far.
 */
function hasWideRange(scene: ResolvedScene): boolean {
  const { objects } = scene;
  const frame = { origin: frameOrigin(scene), scale: 1 };
  const extents = objects.map(({ shape }) => primitiveOf(shape).extent(shape, frame));
  const sizes = objects.map(({ shape }) => primitiveOf(shape).size(shape));
  return (
    Math.max(...extents) >= WIDE_RANGE * Math.min(...sizes) ||
    objects.some(
      ({ shape }, i) => (extents[i] as number) >= CLOSE_UP * primitiveOf(shape).clearance(shape, frame.origin),
    )
  );
}

/** The kinds of all objects that stay in a space of their own, or of the others. */
const kindsOf = ({ objects }: ResolvedScene, placed: boolean): readonly ShapeKind[] =>
  objects.filter(({ shape }) => !!shape.place === placed).map(({ shape }) => shape.type);

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

const counts = <K extends string>(kinds: readonly K[], found: readonly K[]): { readonly [P in K]: number } =>
  Object.fromEntries(kinds.map((kind) => [kind, found.filter((one) => one === kind).length])) as {
    [P in K]: number;
  };

const largest = <K extends string>(
  a: { readonly [P in K]: number },
  b: { readonly [P in K]: number },
): { readonly [P in K]: number } =>
  Object.fromEntries(Object.keys(a).map((kind) => [kind, Math.max(a[kind as K], b[kind as K])])) as {
    [P in K]: number;
  };
