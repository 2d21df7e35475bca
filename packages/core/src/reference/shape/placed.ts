/** Twin of shaders/shape/placed.glsl: a shape that stays in a space of its own is met there, by a ray that is mapped. */
import type { Affine } from '../../affine.ts';
import type { ShapeKind } from '../../primitives/index.ts';
import { length, normalize, scale } from '../../vector.ts';
import type { TracedShape } from './index.ts';

/** A kind of shape, as it is met through a map from its own space to the scene. (U, V) are those of its own space. */
export const placed = <K extends ShapeKind>(own: TracedShape<K>, place: Affine): TracedShape<K> => ({
  distance(shape, ray, leaves) {
    const direction = place.directionBack(ray.direction);
    const rate = length(direction);
    const mapped = { origin: place.pointBack(ray.origin), direction: scale(direction, 1 / rate) };
    return own.distance(shape, mapped, leaves) / rate;
  },
  normal: (shape, point) => normalize(place.normal(own.normal(shape, place.pointBack(point)))),
  lengths: (shape, point) => own.lengths(shape, place.pointBack(point)),
});
