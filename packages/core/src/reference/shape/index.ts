/** What the tracer asks of every kind of primitive; a kind that is missing here does not compile. */
import type { Affine } from '../../affine.ts';
import type { ShapeKind } from '../../primitives/index.ts';
import '../../more-parts.ts';
import type { Shape } from '../../schema.ts';
import type { Vec3 } from '../../vector.ts';
import type { Ray } from '../ray.ts';
import { boxDistance, boxLengths, boxNormal } from './box.ts';
import { coneDistance, coneLengths, coneNormal } from './cone.ts';
import { cylinderDistance, cylinderLengths, cylinderNormal } from './cylinder.ts';
import { discDistance, discLengths, discNormal } from './disc.ts';
import { placed } from './placed.ts';
import { planeDistance, planeLengths, planeNormal } from './plane.ts';
import { quadDistance, quadLengths, quadNormal } from './quad.ts';
import { sphereDistance, sphereLengths, sphereNormal } from './sphere.ts';
import { torusDistance, torusLengths, torusNormal } from './torus.ts';
import { triangleDistance, triangleLengths, triangleNormal } from './triangle.ts';

export interface TracedShape<K extends ShapeKind> {
  /** Distance t > 0 to the nearest intersection, or MISS; `own`: the ray leaves this very object. */
  distance(shape: Shape<K>, ray: Ray, own: boolean): number;
  /** The outward (or front) unit normal. */
  normal(shape: Shape<K>, point: Vec3): Vec3;
  /** The surface lengths (U, V) that a checker is laid out in. */
  lengths(shape: Shape<K>, point: Vec3): readonly [number, number];
}

const tracedShapes: { readonly [K in ShapeKind]: TracedShape<K> } = {
  sphere: { distance: sphereDistance, normal: sphereNormal, lengths: sphereLengths },
  plane: { distance: planeDistance, normal: planeNormal, lengths: planeLengths },
  disc: { distance: discDistance, normal: discNormal, lengths: discLengths },
  quad: { distance: quadDistance, normal: quadNormal, lengths: quadLengths },
  box: { distance: boxDistance, normal: boxNormal, lengths: boxLengths },
  cylinder: { distance: cylinderDistance, normal: cylinderNormal, lengths: cylinderLengths },
  cone: { distance: coneDistance, normal: coneNormal, lengths: coneLengths },
  torus: { distance: torusDistance, normal: torusNormal, lengths: torusLengths },
  triangle: { distance: triangleDistance, normal: triangleNormal, lengths: triangleLengths },
};

export function tracedShape<K extends ShapeKind>(shape: Shape<K> & { readonly place?: Affine }): TracedShape<K> {
  const own = tracedShapes[shape.type as K] as TracedShape<K>;
  return shape.place ? placed(own, shape.place) : own;
}
