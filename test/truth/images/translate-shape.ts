/** The shapes of the neutral description as objects of ours. */
import type { Vec3 } from '@ray-scene/core';
import { addScaled, scale, subtract } from '../../../packages/core/src/vector.ts';
import type { NeutralObject } from './neutral-scene.ts';
import { given, Untranslatable } from './untranslatable.ts';

/** An object of a scene of ours, without its material. */
export type Shape = { readonly type: string };

const shapes: { readonly [shape: string]: (object: NeutralObject) => Shape } = {
  sphere: (object) => ({ type: 'sphere', ...given(object, 'center', 'radius') }),
  rectangle: (object) => ({ type: 'quad', ...given(object, 'corner', 'edgeU', 'edgeV') }),
  disc: (object) => ({ type: 'disc', ...given(object, 'center', 'normal', 'radius') }),
  plane: (object) => ({ type: 'plane', ...given(object, 'point', 'normal') }),
  triangle: (object) => ({ type: 'triangle', ...given(object, 'a', 'b', 'c') }),
  box: (object) => {
    const { min, max } = given(object, 'min', 'max');
    const size = subtract(max, min);
    return { type: 'box', center: addScaled(min, size, 0.5), size };
  },
  cylinder: (object) => {
    const { a, b, radius } = given(object, 'a', 'b', 'radius');
    return { type: 'cylinder', base: a, top: b, radius };
  },
  cone: (object) => {
    const { a, b, radius } = given(object, 'a', 'b', 'radius');
    return { type: 'cone', base: a, tip: b, radius };
  },
  torus: (object) => {
    const { center, axis, major, minor } = given(object, 'center', 'axis', 'major', 'minor');
    return { type: 'torus', center, axis, radius: major, tube: minor };
  },
};

export function shapeOf(object: NeutralObject): Shape {
  const translate = Object.hasOwn(shapes, object.shape) ? shapes[object.shape] : undefined;
  if (!translate) throw new Untranslatable(`there is no ${object.shape}`);
  if (object.capped === false) throw new Untranslatable(`there is no ${object.shape} without caps`);
  return translate(object);
}

/** What keeps its axes: turned about the vertical through its centre, counter-clockwise seen from above. */
export function turned<T extends Shape>(object: T, { rotateYDegrees = 0, min, max, center }: NeutralObject): object {
  if (rotateYDegrees === 0) return object;
  const pivot: Vec3 | undefined = min && max ? scale(addScaled(min, max, 1), 0.5) : center;
  if (!pivot) throw new Untranslatable(`there is no centre to turn a ${object.type} about`);
  const rotation = [0, rotateYDegrees, 0];
  return { type: 'group', position: pivot, rotation, objects: [{ ...object, center: [0, 0, 0] }] };
}
