/** The nearest intersection of a ray with a scene, in f64: for picking and for tests. */
import { resolveScene } from '../resolve-scene.ts';
import type { Scene } from '../schema.ts';
import { addScaled, type Vec3 } from '../vector.ts';
import { nearest } from './nearest.ts';
import { tracedShape } from './shape/index.ts';

export interface Intersection {
  /** Index in `scene.objects`. */
  readonly object: number;
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
  const resolved = resolveScene(scene);
  const hit = nearest(resolved, ray);
  const object = hit && resolved.objects[hit.object];
  if (!object) return undefined;
  const position = addScaled(ray.origin, ray.direction, hit.t);
  const normal = tracedShape(object.shape).normal(object.shape, position);
  return { object: object.index, t: hit.t, position, normal };
}
