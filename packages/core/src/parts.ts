/**
 * What shaders are made of, beyond what every scene needs: how primitives are packed and traced, by kind, and the form of
 * the shader for many objects. Spheres and planes are always there; the rest comes with the module `more-parts.ts`, which a
 * page loads when a scene asks for it.
 */
import planeGlsl from '../../../shaders/shape/plane.glsl';
import sphereGlsl from '../../../shaders/shape/sphere.glsl';
import type { Fields } from './fields.ts';
import type { ShapeKind } from './primitives/index.ts';
import { plane } from './primitives/plane.ts';
import type { Primitive } from './primitives/primitive.ts';
import { sphere } from './primitives/sphere.ts';
import type { Requirements } from './requirements.ts';
import type { BlockLayout, Member } from './std140.ts';

/** A primitive of any kind, with the text of its shader file. */
interface Registered {
  readonly primitive: Primitive<Fields, readonly Member[]>;
  readonly glsl: string;
}

/** The kinds that are not there from the beginning. */
export type MoreKinds = Exclude<ShapeKind, 'sphere' | 'plane'>;

const registered = new Map<string, Registered>([
  ['sphere', { primitive: sphere, glsl: sphereGlsl }],
  ['plane', { primitive: plane, glsl: planeGlsl }],
]);

/** Writes the part of a shader that goes through its objects. */
type ObjectsWriter = (required: Requirements, scene: BlockLayout) => string;

let indexed: ObjectsWriter | undefined;

/** Shader files by name, but for those of `glslFiles` and of the shapes. */
export const moreGlslFiles: { [file: string]: string } = {};

/** What comes with `more-parts.ts`. */
export interface MoreParts {
  readonly shapes: { readonly [K in MoreKinds]: Registered };
  readonly files: { readonly [file: string]: string };
  readonly indexedObjects: ObjectsWriter;
}

/** Makes the other parts known. */
export function registerParts(parts: MoreParts): void {
  for (const [kind, shape] of Object.entries(parts.shapes)) registered.set(kind, shape);
  Object.assign(moreGlslFiles, parts.files);
  indexed = parts.indexedObjects;
}

/** Whether everything is there. */
export const hasMoreParts = (): boolean => !!indexed;

const notLoaded = (what: string): Error => new Error(`${what} is not loaded: await loadParts(scene) first`);

/** @throws {Error} when it has not been loaded. */
export const indexedObjects: ObjectsWriter = (required, scene) => {
  if (!indexed) throw notLoaded('the shader for many objects');
  return indexed(required, scene);
};

/** @throws {Error} when the kind has not been loaded. */
function known(kind: ShapeKind): Registered {
  const shape = registered.get(kind);
  if (!shape) throw notLoaded(`the shape "${kind}"`);
  return shape;
}

/** @throws {Error} when the kind has not been loaded. */
export const primitiveOfKind = (kind: ShapeKind): Registered['primitive'] => known(kind).primitive;

/**
 * The primitive of a shape, for callers to whom its kind does not matter.
 * @throws {Error} when the kind has not been loaded.
 */
export const primitiveOf = (shape: { readonly type: ShapeKind }): Registered['primitive'] =>
  primitiveOfKind(shape.type);

/** The shader file that defines a kind of shape. */
export const shapeFile = (kind: ShapeKind): string => `shape/${kind}.glsl`;

/** The text of that file. */
export const shapeGlsl = (kind: ShapeKind): string => known(kind).glsl;
