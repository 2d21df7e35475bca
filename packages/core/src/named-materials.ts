import type { Material } from './schema.ts';

/** Fields of materials, by name. */
export type NamedMaterials = { readonly [name: string]: Partial<Material> };

let builtIn: NamedMaterials = {};

/** Makes materials known to every scene. */
export function registerMaterials(all: NamedMaterials): void {
  builtIn = all;
}

/** The materials that every scene knows, once they are loaded: a scene that names one is not good before. */
export const knownMaterials = (): NamedMaterials => builtIn;
