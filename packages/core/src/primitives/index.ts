/** The closed list of primitives. A kind added here is missed by the compiler wherever it is not yet handled. */
import type { Fields } from '../fields.ts';
import type { Member } from '../std140.ts';
import { plane } from './plane.ts';
import type { Primitive } from './primitive.ts';
import { sphere } from './sphere.ts';
import { torus } from './torus.ts';

export const primitives = { sphere, plane, torus } as const;

export type ShapeKind = keyof typeof primitives;

/** In the order of the shader's object numbers. */
export const shapeKinds = Object.keys(primitives) as readonly ShapeKind[];

/** The primitive of a shape, for callers to whom its kind does not matter. */
export const primitiveOf = (shape: { readonly type: ShapeKind }): Primitive<Fields, readonly Member[]> =>
  primitives[shape.type];
