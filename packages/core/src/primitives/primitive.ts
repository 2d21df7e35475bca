import type { Fields, Values } from '../fields.ts';
import type { Frame } from '../frame.ts';
import type { Member, RecordValues } from '../std140.ts';
import type { Vec3 } from '../vector.ts';

/** The axis-aligned box that holds a primitive. */
export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

/**
 * What the engine asks of a primitive. Beside it stand `shaders/shape/KIND.glsl` and `reference/shape/KIND.ts`, which
 * define the same functions by the same names (see docs/add-a-primitive.md).
 */
export interface Primitive<F extends Fields, M extends readonly Member[]> {
  readonly doc: string;
  /** What an author may say of it, in the table of fields. */
  readonly fields: F;
  /** What the shader is told of it, one std140 record each. `material` is written by the packer. */
  readonly record: M;
  /** Rounds to f32 last: in: f64 as authored, out: relative to the camera and scaled by `frame`. */
  pack(shape: Values<F>, frame: Frame, checkerSize: number): RecordValues<M>;
  /** What the view must hold, or undefined for what has no end. */
  bounds(shape: Values<F>): Bounds | undefined;
  /** A length that says how large it is, for the scale of the packing. */
  extent(shape: Values<F>, frame: Frame): number;
  /**
   * Whether it can stand between its own lit side and a light: never for flat ones, `inside` for convex solids, where
   * only light from within or a look from within makes a shadow.
   */
  readonly shadowsItself: 'never' | 'inside';
}

/** Lets TypeScript infer the fields and the record of a primitive while it checks the rest. */
export const definePrimitive = <F extends Fields, const M extends readonly Member[]>(
  primitive: Primitive<F, M>,
): Primitive<F, M> => primitive;
