/** What the f64 reference says to a problem. */
import { parseScene, primitives, resolveScene, type Vec3 } from '@ray-scene/core';
import { nearest } from '../../packages/core/src/reference/nearest.ts';
import { tracedShape } from '../../packages/core/src/reference/shape/index.ts';
import { addScaled } from '../../packages/core/src/vector.ts';
import type { Answer, Problem } from './problem.ts';

const NOWHERE: Vec3 = [0, 0, 0];

/** The scene of a problem. Its camera is given beside it: where it looks does not matter. */
export const sceneOf = ({ objects, camera }: Problem) =>
  resolveScene(
    parseScene({
      objects: objects.map((object) => ({ ...object, specular: 0 })),
      environment: { color: 'black' },
      background: 'transparent',
    }),
    1,
    { position: camera, target: NOWHERE, up: [0, 1, 0], fov: 45 },
  );

/** Whether scenes may have such a thing. */
export const isKind = (kind: string): boolean => Object.hasOwn(primitives, kind);

export function referenceAnswer(problem: Problem): Answer {
  const scene = sceneOf(problem);
  const { origin, direction } = problem;
  const hit = nearest(scene, { origin, direction, ...(problem.own ? { own: 0 } : {}) });
  const shape = hit && scene.objects[hit.object]?.shape;
  if (!shape) return { t: Number.POSITIVE_INFINITY, normal: NOWHERE };
  return { t: hit.t, normal: tracedShape(shape).normal(shape, addScaled(origin, direction, hit.t)) };
}
