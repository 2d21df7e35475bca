/**
 * What shaders are made of, beyond what every scene needs. Spheres and planes are always there; the other shapes, the form
 * for many objects and that for software renderers come with the module `more-parts.ts`, which a page loads when it must.
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
interface Part {
  readonly primitive: Primitive<Fields, readonly Member[]>;
  readonly glsl: string;
}

/** How primitives are packed and traced. */
const shapes: { [K in ShapeKind]?: Part } = {
  sphere: { primitive: sphere, glsl: sphereGlsl },
  plane: { primitive: plane, glsl: planeGlsl },
};

/** What comes with `more-parts.ts`. */
export interface MoreParts {
  readonly shapes: { readonly [K in Exclude<ShapeKind, 'sphere' | 'plane'>]: Part };
  /** Shader files by name, but for those of `glslFiles` and of the shapes. */
  readonly files: { readonly [file: string]: string };
  /** Writes the part of a shader that goes through many objects. */
  readonly indexedObjects: (required: Requirements, scene: BlockLayout) => string;
  /** Writes what hands a scene's numbers on as varyings. */
  readonly rows: Pick<typeof import('./varying-rows.ts'), 'varyingRows' | 'structFromRows'>;
}

let more: MoreParts | undefined;

/** Makes the other parts known. */
export function registerParts(parts: MoreParts): void {
  more = parts;
  Object.assign(shapes, parts.shapes);
}

/** The other parts, if they are loaded. */
export const loadedParts = (): MoreParts | undefined => more;

const present = <T>(part: T | undefined): T => {
  if (part) return part;
  throw new Error('a part of the scene is not loaded: await loadShapes(scene), and loadShaderParts(requirements)');
};

/** @throws {Error} when they have not been loaded. */
export const moreParts = (): MoreParts => present(more);

/** @throws {Error} when the kind has not been loaded. */
export const primitiveOfKind = (kind: ShapeKind): Part['primitive'] => present(shapes[kind]).primitive;

/**
 * The primitive of a shape, for callers to whom its kind does not matter.
 * @throws {Error} when the kind has not been loaded.
 */
export const primitiveOf = (shape: { readonly type: ShapeKind }): Part['primitive'] => primitiveOfKind(shape.type);

/** The shader file that defines a kind of shape. */
export const shapeFile = (kind: ShapeKind): string => `shape/${kind}.glsl`;

/** The text of that file. */
export const shapeGlsl = (kind: ShapeKind): string => present(shapes[kind]).glsl;
