/** Twin of the generated shaders/generated/nearest.glsl: which object a ray meets first, and whether any is in its way. */
import type { ResolvedScene } from '../resolve-scene.ts';
import { MISS, type Ray } from './ray.ts';
import { tracedShape } from './shape/index.ts';

export interface Hit {
  /** Number of the object in `scene.objects`. */
  readonly object: number;
  readonly t: number;
}

/** The nearest intersection with t > 0. */
export function nearest({ objects }: ResolvedScene, ray: Ray): Hit | undefined {
  let hit: Hit | undefined;
  objects.forEach(({ shape }, object) => {
    const t = tracedShape(shape).distance(shape, ray, ray.own === object);
    if (t < (hit?.t ?? MISS)) hit = { object, t };
  });
  return hit;
}

/** Whether something is in the way within a distance, other than the lamp that is there. */
export const occluded = ({ objects }: ResolvedScene, ray: Ray, limit: number, lamp?: number): boolean =>
  objects.some(
    ({ shape }, object) => object !== lamp && tracedShape(shape).distance(shape, ray, ray.own === object) < limit,
  );
