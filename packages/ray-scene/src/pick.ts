/** What is seen at a point of a picture, found by the f64 tracer. A chunk that is loaded when somebody first asks. */
import {
  cameraFrame,
  cameraRay,
  type Intersection,
  intersect,
  type Problem,
  type ResolvedCamera,
  type Scene,
  type Vec3,
} from '@ray-scene/core';

/** Whose picture it is. */
export interface PickHost {
  readonly scene: Scene | undefined;
  readonly camera: ResolvedCamera | undefined;
  /** The child element that a node of the scene was read from. */
  elementOf(path: Problem['path']): Element | undefined;
}

/** What is seen at a point. */
export interface Picked extends Intersection {
  /** Along the ray from the camera, in the scene's unit of length. */
  readonly t: number;
  /** The child element that it was read from, if the scene is made of those. */
  readonly element: Element | undefined;
}

/** Where a picture is on the page, in CSS pixels. */
type Box = Pick<DOMRect, 'left' | 'top' | 'width' | 'height'>;

/**
 * The nearest surface at a point of the page, in client coordinates as those of a pointer event; undefined where there is
 * none. A lens counts as a pinhole: what is picked is in the middle of what is blurred.
 */
export function pick(host: PickHost, box: Box, x: number, y: number): Picked | undefined {
  const { scene, camera } = host;
  const [right, down] = [x - box.left, y - box.top];
  const isInside = right >= 0 && down >= 0 && right < box.width && down < box.height;
  if (!scene || !camera || !isInside) return undefined;
  const frame = cameraFrame({ ...camera, aperture: 0 }, box.width, box.height);
  const { start, direction } = cameraRay(frame, right, box.height - down);
  const hit = intersect(scene, { origin: add(frame.origin, start), direction });
  if (!hit) return undefined;
  const { light, path } = hit;
  const node = light === undefined ? path.flatMap((index) => ['objects', index]) : ['lights', light];
  return { ...hit, element: host.elementOf(node) };
}

const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
