import type { Scene } from './schema.ts';

/**
 * A scene as plain JSON data: `parseScene(serializeScene(scene))` equals `scene`. Colours are linear `[r, g, b]`,
 * defaults are written out.
 */
export function serializeScene(scene: Scene): { [key: string]: unknown } {
  return JSON.parse(JSON.stringify(scene));
}
