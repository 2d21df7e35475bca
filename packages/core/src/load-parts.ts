import type { ShaderOptions } from './generate-shader.ts';
import { loadedParts } from './parts.ts';
import type { Scene } from './schema.ts';

/** Scenes of so many spheres and planes, and of so many lights, one after the other, never make up one of many. */
const FEW = 4;

/**
 * Loads what a scene needs beyond a few spheres and planes on a GPU; undefined: it is all there. A scene with other shapes
 * can be resolved, packed and traced only after that.
 */
export function loadParts(
  { objects, lights }: Pick<Scene, 'objects' | 'lights'>,
  { varyings = 0 }: ShaderOptions = {},
): Promise<unknown> | undefined {
  const isSimple = varyings === 0 && objects.every(({ type }) => type === 'sphere' || type === 'plane');
  if (loadedParts() || (isSimple && objects.length <= FEW && lights.length <= FEW)) return undefined;
  return import('./more-parts.ts');
}
