/**
 * The closed list of primitives: what an author may say of them. A kind added here is missed by the compiler wherever it is
 * not yet handled. What else the engine must know of a kind comes with `more-parts.ts`.
 */
import { boxTable } from './box.ts';
import { coneTable } from './cone.ts';
import { cylinderTable } from './cylinder.ts';
import { discTable } from './disc.ts';
import { plane } from './plane.ts';
import { quadTable } from './quad.ts';
import { sphere } from './sphere.ts';
import { torusTable } from './torus.ts';
import { triangleTable } from './triangle.ts';

export const primitives = {
  sphere: { doc: sphere.doc, fields: sphere.fields },
  plane: { doc: plane.doc, fields: plane.fields },
  disc: discTable,
  quad: quadTable,
  box: boxTable,
  cylinder: cylinderTable,
  cone: coneTable,
  torus: torusTable,
  triangle: triangleTable,
} as const;

export type ShapeKind = keyof typeof primitives;

/** In the order of the shader's object numbers. */
export const shapeKinds = Object.keys(primitives) as readonly ShapeKind[];
