/**
 * What shaders are made of, beyond what every scene needs. Spheres and planes are always there; the other shapes, the form
 * for many objects and that for software renderers come with the module `more-parts.ts`, which a page loads when it must.
 */
import type { Affine } from './affine.ts';
import type { CameraFrame } from './camera-frame.ts';
import type { Feature } from './features.ts';
import type { Fields } from './fields.ts';
import type { FlatScene } from './flat-scene.ts';
import type { Frame } from './frame.ts';
import type { ShapeKind } from './primitives/index.ts';
import { plane } from './primitives/plane.ts';
import type { Primitive } from './primitives/primitive.ts';
import { sphere } from './primitives/sphere.ts';
import type { Requirements } from './requirements.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { SceneNeeds, Tracing } from './scene-needs.ts';
import type { Scene } from './schema.ts';
import type { BlockEntry, BlockLayout, Member, RecordValues } from './std140.ts';
import type { Vec3 } from './vector.ts';
import type { SampleNumber } from './view-record.ts';

type AnyPrimitive = Primitive<Fields, readonly Member[]>;

/** How primitives are packed. */
const shapes: { [K in ShapeKind]?: AnyPrimitive } = { sphere, plane };

/** What comes with `more-parts.ts`. */
export interface MoreParts {
  /** All of them: spheres and planes for which nothing is too much. */
  readonly shapes: { readonly [K in ShapeKind]: AnyPrimitive };
  /** Shader files by name, but for those of `glslFiles`. */
  readonly files: { readonly [file: string]: string };
  /** Writes the part of a shader that goes through many objects. */
  readonly indexedObjects: (required: Requirements, scene: BlockLayout) => string;
  readonly flattenGroups: (scene: Scene) => FlatScene;
  /** How shapes are packed that stay in a space of their own. */
  readonly placed: typeof import('./placed-shape.ts');
  /** Writes what hands a scene's numbers on as varyings. */
  readonly rows: Pick<typeof import('./varying-rows.ts'), 'varyingRows' | 'structFromRows'>;
}

/** An emitter as the shader is told of it, and the number in the scene of the object that it is. */
export interface PackedEmitter {
  readonly record: RecordValues<readonly Member[]>;
  readonly object: number | undefined;
}

/** What comes with `path-parts.ts`, for scenes that are gone through path by path. */
export interface PathParts {
  /** Shader files by name. */
  readonly files: { readonly [file: string]: string };
  /** What the integrator asks of a scene, beyond what its nodes say by themselves. */
  needs(scene: ResolvedScene, tracing: Tracing): { readonly features: readonly Feature[]; readonly emitters: number };
  /** What it needs of all that the nodes bring with them. */
  features(needs: SceneNeeds): ReadonlySet<Feature>;
  /** What is told of the `index`-th material, besides the rest. `emitter`: its place among the emitters, -1 for none. */
  readonly materialRecord: readonly Member[];
  packMaterial(scene: ResolvedScene, index: number, frame: Frame, emitter: number): RecordValues<readonly Member[]>;
  /** The origin of the space that the scene is packed in. */
  origin(scene: ResolvedScene): Vec3;
  /** What the shader is told of the eye besides, or instead. */
  readonly eyeRecord: readonly Member[];
  packEye(view: CameraFrame, frame: Frame, sample: SampleNumber): RecordValues<readonly Member[]>;
  /** What the block `Scene` holds of so many emitters. */
  emitterEntries(features: readonly Feature[], capacity: number): readonly BlockEntry[];
  /** The part of a shader that tells kinds of emitters apart. */
  emittersGlsl(features: readonly Feature[]): string;
  /** Numbers that the text of a shader holds. */
  limitsGlsl(required: Requirements): string;
  /**
   * All emitters and glints, and as many without light as are missing of what is required. `numbers` are those of the
   * scene's objects in the shader.
   */
  packEmitters(
    scene: ResolvedScene,
    frame: Frame,
    numbers: readonly number[],
    required: Pick<Requirements, 'emitters' | 'features'>,
  ): {
    readonly emitters: readonly PackedEmitter[];
    readonly choice: RecordValues<readonly Member[]>;
    readonly glints: readonly RecordValues<readonly Member[]>[];
  };
}

let paths: PathParts | undefined;

/** Makes paths known. */
export function registerPaths(parts: PathParts): void {
  paths = parts;
}

/** What paths need, if it is loaded. */
export const loadedPaths = (): PathParts | undefined => paths;

/** @throws {Error} when it has not been loaded. */
export const pathParts = (): PathParts => present(paths);

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
export const primitiveOfKind = (kind: ShapeKind): AnyPrimitive => present(shapes[kind]);

/**
 * The primitive of a shape, for callers to whom its kind does not matter.
 * @throws {Error} when the kind has not been loaded.
 */
export function primitiveOf({ type, place }: { readonly type: ShapeKind; readonly place?: Affine }): AnyPrimitive {
  const primitive = primitiveOfKind(type);
  return place ? moreParts().placed.placedPrimitive(primitive, place) : primitive;
}
