/** Ways to move a camera about what it looks at, as a person at the controls does. Each returns a new camera. */
import { cameraAxes, type ResolvedCamera } from './camera-frame.ts';
import { add, addScaled, cross, dot, length, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** How near to straight above or below a camera may come, in radians: there `up` would have no meaning. */
const POLE_MARGIN = 1e-3;

/** Walks around the target: `right` radians about the camera's `up`, `over` radians towards it. */
export function orbitCamera(camera: ResolvedCamera, right: number, over: number): ResolvedCamera {
  const pole = normalize(camera.up);
  const offset = subtract(camera.position, camera.target);
  const distance = length(offset);
  const outward = scale(offset, 1 / distance);
  const ahead = normalize(addScaled(outward, pole, -dot(outward, pole)));
  const walked = add(scale(ahead, Math.cos(right)), scale(cross(pole, ahead), Math.sin(right)));
  const polar = Math.atan2(dot(outward, ahead), dot(outward, pole)) - over;
  const angle = Math.min(Math.PI - POLE_MARGIN, Math.max(POLE_MARGIN, polar));
  const direction = add(scale(pole, Math.cos(angle)), scale(walked, Math.sin(angle)));
  return { ...camera, position: addScaled(camera.target, direction, distance) };
}

/** Brings the camera to `factor` times its distance from the target. */
export function zoomCamera(camera: ResolvedCamera, factor: number): ResolvedCamera {
  const offset = subtract(camera.position, camera.target);
  return { ...camera, position: addScaled(camera.target, offset, factor) };
}

/** Moves camera and target sideways, by fractions of the height of the picture at the target. */
export function panCamera(camera: ResolvedCamera, right: number, up: number): ResolvedCamera {
  const axes = cameraAxes(camera);
  const height = 2 * length(subtract(camera.position, camera.target)) * Math.tan((camera.fov * Math.PI) / 360);
  const move = (point: Vec3) => addScaled(addScaled(point, axes.right, right * height), axes.up, up * height);
  return { ...camera, position: move(camera.position), target: move(camera.target) };
}
