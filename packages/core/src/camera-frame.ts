/** The camera as a ray generator. Packing and the reference tracer share it, so that both shoot the same rays. */
import { add, addScaled, cross, length, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** A camera with nothing left open. */
export interface ResolvedCamera {
  readonly position: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** Vertical field of view in degrees. */
  readonly fov: number;
}

/**
 * The ray through the window point (x, y), counted in pixels from the lower left corner as `gl_FragCoord` does, starts
 * at `origin` and runs along corner + x stepX + y stepY (not of unit length).
 */
export interface CameraFrame {
  readonly origin: Vec3;
  readonly corner: Vec3;
  readonly stepX: Vec3;
  readonly stepY: Vec3;
  /** Of the window, in pixels. */
  readonly width: number;
  readonly height: number;
}

/** Right, up and forward of a camera, as unit vectors. */
export function cameraAxes({ position, target, up }: ResolvedCamera): { right: Vec3; up: Vec3; forward: Vec3 } {
  const forward = normalize(subtract(target, position));
  const sideways = cross(forward, normalize(up));
  // Straight up or down, `up` says nothing: then -z is up, as on a map whose north is -z; or x, if that is no use either.
  const other: Vec3 = Math.abs(forward[2]) < 0.9 ? [0, 0, -1] : [1, 0, 0];
  const right = normalize(length(sideways) > Number.EPSILON ? sideways : cross(forward, other));
  return { right, up: cross(right, forward), forward };
}

/**
 * Rays for one sample: `jitter` is the sample's place in every pixel, [0, 1)², x to the right and y down; pixel centres
 * are at [½, ½].
 */
export function cameraFrame(
  camera: ResolvedCamera,
  width: number,
  height: number,
  jitter: readonly [number, number] = [0.5, 0.5],
): CameraFrame {
  const axes = cameraAxes(camera);
  const halfHeight = Math.tan((camera.fov * Math.PI) / 360);
  const stepX = scale(axes.right, (2 * halfHeight) / height);
  const stepY = scale(axes.up, (2 * halfHeight) / height);
  const fromCenter = add(scale(stepX, jitter[0] - 0.5 - width / 2), scale(stepY, 0.5 - jitter[1] - height / 2));
  return { origin: camera.position, corner: add(axes.forward, fromCenter), stepX, stepY, width, height };
}

/** The direction of the ray through the window point (x, y). */
export const rayDirection = (frame: CameraFrame, x: number, y: number): Vec3 =>
  addScaled(addScaled(frame.corner, frame.stepX, x), frame.stepY, y);
