/** Twin of shaders/tangents.glsl. */
import type { Vec3 } from '../vector.ts';

/** Where the formula changes over: at a normal that no floor, wall or roof has, so that f32 and f64 go the same way. */
const TURN = -0.6180339887;

/**
 * Two unit vectors x and y that make a right-handed frame with the unit normal n as its z.
 * Source: T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017; there it changes over at n.z = 0.
 */
export function tangents([x, y, z]: Vec3): readonly [Vec3, Vec3] {
  const sign = z > TURN ? 1 : -1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  return [
    [1 + sign * x * x * a, sign * b, -sign * x],
    [b, sign + y * y * a, -y],
  ];
}
