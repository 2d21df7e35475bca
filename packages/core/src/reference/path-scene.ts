/** A scene made ready for the integrator `path`: with what can be asked for light. */

import { type AliasTable, emitterTable } from '../emitter-table.ts';
import { type Emitter, sceneEmitters } from '../emitters.ts';
import type { ResolvedScene } from '../resolve-scene.ts';

export interface PathScene extends ResolvedScene {
  /** Whether it is for the integrator `direct`. */
  readonly whitted: boolean;
  /** Radiance above which samples are dimmed. */
  readonly clamp: number;
  readonly emitters: readonly Emitter[];
  readonly table: AliasTable;
  /** By number of the object: its place among the emitters, if it is one. */
  readonly emitterOf: readonly (number | undefined)[];
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
  return { ...scene, whitted: integrator === 'direct', clamp, emitters, table: emitterTable(emitters), emitterOf };
}
