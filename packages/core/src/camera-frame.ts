/** The camera as a ray generator. Packing and the reference tracer share it, so that both shoot the same rays. */
import { add, addScaled, cross, length, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** A camera with nothing left open. */
export interface ResolvedCamera {
  readonly position: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** Vertical field of view in degrees. */
  readonly fov: number;
  /** Default: perspective. */
  readonly type?: 'perspective' | 'orthographic';
  /** Of an orthographic view; default: what `fov` shows at the target. */
  readonly height?: number;
  /** Radius of the lens of a perspective view; default: 0. */
  readonly aperture?: number;
  /** How far ahead the plane in focus is; default: as far as the target. */
  readonly focusDistance?: number;
}

/** In degrees. Below it, directions in f32 hold too few digits to tell pixels apart: see `rayStart`. */
export const NARROW_FOV = 0.5;

/**
 * With w = corner + x stepX + y stepY for the window point (x, y), counted in pixels from the lower left corner as
 * `gl_FragCoord` does, the ray through it starts at `origin` and runs along w (not of unit length). With a lens it starts
 * at a point of that and runs to the point in focus, `origin` + focus w; in an orthographic view it starts at `origin` + w
 * and runs along `forward`.
 */
export interface CameraFrame {
  readonly origin: Vec3;
  readonly forward: Vec3;
  readonly orthographic: boolean;
  /** Two radii of the lens, at right angles; undefined for a pinhole. */
  readonly lens?: readonly [Vec3, Vec3];
  readonly focus: number;
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

/** The rays of a camera whose window has so many pixels. */
export function cameraFrame(camera: ResolvedCamera, width: number, height: number): CameraFrame {
  const axes = cameraAxes(camera);
  const toTarget = length(subtract(camera.target, camera.position));
  const halfHeight = Math.tan((camera.fov * Math.PI) / 360);
  const orthographic = camera.type === 'orthographic';
  const viewHeight = orthographic ? (camera.height ?? 2 * halfHeight * toTarget) : 2 * halfHeight;
  const stepX = scale(axes.right, viewHeight / height);
  const stepY = scale(axes.up, viewHeight / height);
  const fromCenter = add(scale(stepX, -width / 2), scale(stepY, -height / 2));
  const { aperture = 0, focusDistance = toTarget } = camera;
  const hasLens = aperture > 0 && !orthographic;
  return {
    origin: camera.position,
    forward: axes.forward,
    orthographic,
    ...(hasLens ? { lens: [scale(axes.right, aperture), scale(axes.up, aperture)] } : {}),
    focus: focusDistance,
    corner: orthographic ? fromCenter : add(axes.forward, fromCenter),
    stepX,
    stepY,
    width,
    height,
  };
}

/** The point of the window that rays through (x, y) go through; their direction where they all start at `origin`. */
export const rayDirection = (frame: CameraFrame, x: number, y: number): Vec3 =>
  addScaled(addScaled(frame.corner, frame.stepX, x), frame.stepY, y);

/**
 * The unit direction of the ray through (x, y), and its start relative to `origin`; `onLens`: of the unit disc. `ahead`: it
 * starts in the plane that is so far ahead, if there is no lens.
 */
export function cameraRay(
  frame: CameraFrame,
  x: number,
  y: number,
  onLens: readonly [number, number] = [0, 0],
  ahead = 0,
): { readonly start: Vec3; readonly direction: Vec3 } {
  const window = rayDirection(frame, x, y);
  if (frame.orthographic) return { start: addScaled(window, frame.forward, ahead), direction: frame.forward };
  if (!frame.lens) return { start: scale(window, ahead), direction: normalize(window) };
  const start = addScaled(scale(frame.lens[0], onLens[0]), frame.lens[1], onLens[1]);
  return { start, direction: normalize(subtract(scale(window, frame.focus), start)) };
}
