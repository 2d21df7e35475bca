import { knowsAllColors } from './color.ts';
import type { Feature } from './features.ts';
import { glslName, type ShaderOptions } from './generate-shader.ts';
import { loadedParts, loadedPaths } from './parts.ts';
import type { Requirements } from './requirements.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { followsPaths, type Tracing } from './scene-needs.ts';
import type { Material, Scene, SceneNode } from './schema.ts';

/** What comes with `more-parts.ts`. */
const MORE_FEATURES: ReadonlySet<Feature> = new Set([
  'metal',
  'specularTint',
  'specularWeight',
  'mixedFalloff',
  'sphereChecker',
  'tiltedPlane',
  'turnedChecker',
  'environment',
  'gradient',
  'backgroundEnvironment',
  'inside',
  'closeSphere',
  'through',
  'wideRange',
  'indexed',
  'exactRays',
]);

/** What GLSL asks for that is defined only where `more-parts.ts` is there. */
export const moreNames: readonly string[] = [...[...MORE_FEATURES].map(glslName), 'DIRECTIONAL_LIGHTS', 'VARYINGS'];

/**
 * Loads the colours of CSS, and what to say of a scene. Without them a scene may be refused that has nothing wrong, and
 * nobody is told why; undefined: they are there.
 */
export const loadWords = (): Promise<unknown> | undefined => (knowsAllColors() ? undefined : import('./words.ts'));

/**
 * Loads the shapes of a scene, which can be resolved, packed and traced only after that; undefined: they are all there, as
 * spheres and planes always are.
 */
export const loadShapes = ({ objects }: Pick<Scene, 'objects'>): Promise<unknown> | undefined =>
  loadUnless(objects.every(({ type }) => type === 'sphere' || type === 'plane'));

/** Loads what going through a scene path by path takes, before it is known what that requires; undefined: it is there. */
export const loadPaths = (scene: ResolvedScene, tracing: Partial<Tracing>): Promise<unknown> | undefined =>
  loadedPaths() || !followsPaths(scene, tracing)
    ? undefined
    : Promise.all([loadUnless(false), import('./path-parts.ts')]);

/** Loads what the shader of a scene is made of, before it can be generated; undefined: it is all there. */
export const loadShaderParts = (
  { features, lights }: Requirements,
  { varyings = 0 }: ShaderOptions = {},
): Promise<unknown> | undefined =>
  loadUnless(varyings === 0 && lights.directional === 0 && !features.some((feature) => MORE_FEATURES.has(feature)));

/** Whether a scene names images, which are to be loaded first. */
export const namesImages = ({ environment, materials, objects }: Scene): boolean =>
  !!environment?.src || [...Object.values(materials), ...objects].some(hasMap);

const hasMap = (node: Partial<Material> | SceneNode): boolean =>
  'objects' in node ? node.objects.some(hasMap) : !!(node as Partial<Material>).map;

const loadUnless = (hasAll: boolean): Promise<unknown> | undefined =>
  hasAll || loadedParts() ? undefined : import('./more-parts.ts');
