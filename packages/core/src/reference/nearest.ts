/** Twin of the generated shaders/generated/nearest.glsl: which object a ray meets first, and whether any is in its way. */
import type { ShapeKind } from '../primitives/index.ts';
import type { ResolvedObject, ResolvedScene } from '../resolve-scene.ts';
import { MISS, type Ray } from './ray.ts';
import { type TracedShape, tracedShape } from './shape/index.ts';

/** An object and, where many rays are to come, how its shape is met: found once. */
export interface TracedObject extends ResolvedObject {
  readonly traced?: TracedShape<ShapeKind>;
}

export interface TracedScene extends ResolvedScene {
  readonly objects: readonly TracedObject[];
}

export interface Hit {
  /** Number of the object in `scene.objects`. */
  readonly object: number;
  readonly t: number;
}

/** The nearest intersection with t > 0. */
export function nearest({ objects }: TracedScene, ray: Ray): Hit | undefined {
  let object = -1;
  let t = MISS;
  for (let i = 0; i < objects.length; i++) {
    const distance = distanceTo(objects[i] as TracedObject, ray, i);
    if (distance < t) [object, t] = [i, distance];
  }
  return object < 0 ? undefined : { object, t };
}

/** Whether something is in the way within a distance, other than the lamp that is there. */
export function occluded({ objects }: TracedScene, ray: Ray, limit: number, lamp?: number): boolean {
  for (let i = 0; i < objects.length; i++) {
    if (i !== lamp && distanceTo(objects[i] as TracedObject, ray, i) < limit) return true;
  }
  return false;
}

const distanceTo = ({ shape, traced = tracedShape(shape) }: TracedObject, ray: Ray, number: number): number =>
  traced.distance(shape, ray, ray.own === number);
