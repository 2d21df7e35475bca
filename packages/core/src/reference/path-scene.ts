/** A scene made ready for the integrator `path`: with what can be asked for light. */

import { type AliasTable, emitterTable } from '../emitter-table.ts';
import { type Emitter, sceneEmitters } from '../emitters.ts';
import { type Glint, sceneGlints } from '../glints.ts';
import type { ResolvedScene } from '../resolve-scene.ts';
import { scale, type Vec3 } from '../vector.ts';
import type { TracedObject } from './nearest.ts';
import { tracedShape } from './shape/index.ts';

export interface PathScene extends ResolvedScene {
  /** Whether it is for the integrator `direct`. */
  readonly whitted: boolean;
  readonly objects: readonly TracedObject[];
  /** Radiance above which samples are dimmed. */
  readonly clamp: number;
  readonly emitters: readonly Emitter[];
  readonly table: AliasTable;
  /** By number of the object: its place among the emitters, if it is one. */
  readonly emitterOf: readonly (number | undefined)[];
  /** What paths look for on purpose. */
  readonly glints: readonly Glint[];
}

export function preparePaths(
  scene: ResolvedScene,
  integrator: 'path' | 'direct',
  clamp = Number.POSITIVE_INFINITY,
): PathScene {
  const emitters = sceneEmitters(scene);
  const emitterOf: (number | undefined)[] = [];
  emitters.forEach((emitter, i) => {
    if ('object' in emitter) emitterOf[emitter.object] = i;
  });
  return {
    ...scene,
    objects: scene.objects.map((object) => {
      const shape = alike(object.shape);
      return { ...object, shape, traced: tracedShape(shape) };
    }),
    materials: scene.materials.map(alike),
    whitted: integrator === 'direct',
    clamp,
    emitters,
    table: emitterTable(emitters),
    emitterOf,
    glints: integrator === 'direct' ? [] : sceneGlints(scene, emitters),
  };
}

/**
 * A copy that engines of JavaScript know as one of many of the same make. The frozen objects of a parsed scene are each of
 * a make of its own to them, and take ten times as long to read.
 */
function alike<T extends object>(frozen: T): T {
  const copy: { [field: string]: unknown } = {};
  for (const [field, value] of Object.entries(frozen)) copy[field] = isVector(value) ? scale(value, 1) : value;
  return copy as T;
}

const isVector = (value: unknown): value is Vec3 =>
  Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === 'number');
