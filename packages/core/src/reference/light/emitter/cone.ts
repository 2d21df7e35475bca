/** Twin of shaders/light/emitter/cone.glsl: directions around an axis, all equally likely. */
import { add, addScaled, scale, type Vec3 } from '../../../vector.ts';
import { circle } from '../../circle.ts';
import { tangents } from '../../tangents.ts';

/** Per solid angle, in a cone whose half-angle has the cosine 1 - cone. */
export const conePdf = (cone: number): number => 1 / (2 * Math.PI * cone);

/** A unit vector in that cone around a unit axis. */
export function coneDirection(axis: Vec3, cone: number, u: readonly [number, number]): Vec3 {
  const below = u[0] * cone;
  const [x, y] = tangents(axis);
  const [cosine, sine] = circle(u[1]);
  // (1 - cos²) = (1 - cos)(1 + cos)
  const away = Math.sqrt(below * (2 - below));
  return add(scale(axis, 1 - below), addScaled(scale(x, away * cosine), y, away * sine));
}
