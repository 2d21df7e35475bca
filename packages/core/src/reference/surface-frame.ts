/** Twin of shaders/surface-frame.glsl: directions at a surface, in its own frame. */
import { add, dot, scale, type Vec3 } from '../vector.ts';
import { tangents } from './tangents.ts';

/** Two tangents, and the normal as z. */
export type SurfaceFrame = readonly [Vec3, Vec3, Vec3];

export const surfaceFrame = (normal: Vec3): SurfaceFrame => [...tangents(normal), normal];

export const toLocal = ([x, y, z]: SurfaceFrame, v: Vec3): Vec3 => [dot(x, v), dot(y, v), dot(z, v)];

export const toWorld = ([x, y, z]: SurfaceFrame, v: Vec3): Vec3 =>
  add(add(scale(x, v[0]), scale(y, v[1])), scale(z, v[2]));
