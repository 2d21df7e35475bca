import type { Fields, Values } from '../fields.ts';
import type { Frame } from '../frame.ts';
import type { Member, RecordValues } from '../std140.ts';
import type { Vec3 } from '../vector.ts';

/** The axis-aligned box that holds a primitive. */
export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** What else a record may depend on. */
export interface PackContext {
  /** The part of space that the camera is in; see `side`. */
  readonly side: 1 | -1;
  /** Of the object's material. */
  readonly checkerSize: number;
  /** Whether the shader wants positions and directions in more than one word; see `scene-needs.ts`. */
  readonly wideRange: boolean;
}

/**
 * What the engine asks of a primitive. Beside it stand `shaders/shape/KIND.glsl` and `reference/shape/KIND.ts`, which
 * define the same functions by the same names (see docs/add-a-primitive.md).
 */
export interface Primitive<F extends Fields, M extends readonly Member[]> {
  readonly doc: string;
  /** What an author may say of it, in the table of fields. */
  readonly fields: F;
  /** What the shader is told of it, one std140 record each. */
  readonly record: M;
  /** In f64, relative to the camera and scaled by `frame`: rounding to f32 is the last step. `side` is the camera's. */
  pack(shape: Values<F>, frame: Frame, context: PackContext): RecordValues<M>;
  /** Whether it has an inside, where light that passes through it is in another medium. */
  readonly closed: boolean;
  /** A record that no ray meets, for the place of an object that is gone: needed where one of zeros is not that. */
  readonly absent?: RecordValues<M> | undefined;
  /** What the view must hold, or undefined for what has no end. */
  bounds(shape: Values<F>): Bounds | undefined;
  /** A length that says how large it is, for the scale of the packing. */
  extent(shape: Values<F>, frame: Frame): number;
  /** The smallest of its lengths; Infinity for what has none. */
  size(shape: Values<F>): number;
  /** How far a point is from its surface: exact where the point is near, roughly where it is far. */
  clearance(shape: Values<F>, point: Vec3): number;
  /**
   * Which part of space a point is in, where the primitive parts space in two (a solid, a plane without end): 1 in front
   * or outside, -1 behind or inside. Paths of light that do not pass through surfaces stay on the camera's side.
   */
  side(shape: Values<F>, point: Vec3): 1 | -1;
  /** The part of space that one gets to in a direction without end; 0 where that depends on the start. */
  farSide(shape: Values<F>, direction: Vec3): 1 | 0 | -1;
  /**
   * Whether it can stand between two points on this side of it. A convex solid cannot for points inside, nor a plane for
   * points in front or behind.
   */
  occludes(side: 1 | -1): boolean;
}

/** Lets TypeScript infer the fields and the record of a primitive while it checks the rest. */
export const definePrimitive = <F extends Fields, const M extends readonly Member[]>(
  primitive: Primitive<F, M>,
): Primitive<F, M> => primitive;
