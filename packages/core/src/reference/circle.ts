/** Twin of shaders/circle.glsl. */

/** The unit vector at the angle 2πu, for u in [0, 1]. */
export const circle = (u: number): readonly [number, number] => [Math.cos(2 * Math.PI * u), Math.sin(2 * Math.PI * u)];
