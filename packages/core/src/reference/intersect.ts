/** The nearest intersection of a ray with a scene, in f64: for picking and for tests. */
import { type ResolvedScene, resolveScene } from '../resolve-scene.ts';
import type { Scene } from '../schema.ts';
import { addScaled, length, scale, type Vec3 } from '../vector.ts';
import { nearest } from './nearest.ts';
import { tracedShape } from './shape/index.ts';

export interface Intersection {
  /** Index in `scene.objects`, of the outermost group of an object that is in groups; -1: the visible ball of a light. */
  readonly object: number;
  /** Where it is in the scene: `[2, 0]` is `scene.objects[2].objects[0]`; empty for the ball of a light. */
  readonly path: readonly number[];
  /** Of such a ball, the index of its light in `scene.lights`, after which those count that are in groups. */
  readonly light?: number;
  /** In units of the direction's length: the point is origin + t direction. */
  readonly t: number;
  readonly position: Vec3;
  /** The outward (or front) unit normal, not turned towards the ray. */
  readonly normal: Vec3;
}

/** What the ray meets first at t > 0, or undefined. The direction need not be of unit length, but not zero. */
export function intersect(
  scene: Scene,
  ray: { readonly origin: Vec3; readonly direction: Vec3 },
): Intersection | undefined {
  const resolved = resolvedOf(scene);
  // Shapes are met by rays of unit length.
  const size = length(ray.direction);
  const hit = nearest(resolved, { origin: ray.origin, direction: scale(ray.direction, 1 / size) });
  const object = hit && resolved.objects[hit.object];
  if (!object) return undefined;
  const t = hit.t / size;
  const position = addScaled(ray.origin, ray.direction, t);
  const normal = tracedShape(object.shape).normal(object.shape, position);
  const light = object.light === undefined ? {} : { light: object.light };
  const { path } = object;
  return { object: path[0] ?? -1, path, ...light, t, position, normal };
}

/** Whoever follows a pointer asks for the same scene again and again; scenes are frozen, so one answer is enough. */
const resolvedScenes = new WeakMap<Scene, ResolvedScene>();

function resolvedOf(scene: Scene): ResolvedScene {
  const resolved = resolvedScenes.get(scene) ?? resolveScene(scene);
  resolvedScenes.set(scene, resolved);
  return resolved;
}
