/** A camera for a scene that does not say where it stands, or not all of it. */

import type { ResolvedCamera } from './camera-frame.ts';
import { flatScene } from './flat-scene.ts';
import { primitiveOf } from './parts.ts';
import type { Bounds } from './primitives/primitive.ts';
import { type Camera, camera as cameraTable, type Scene } from './schema.ts';
import { add, addScaled, length, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** From slightly above the front: where one stands before a thing on a table. */
const VIEW_DIRECTION = normalize([0.25, 0.35, 1]);

/** Air around the objects: how much farther the camera stands than where it just sees their bounding sphere. */
const MARGIN = 1.05;

/**
 * The author's camera, completed. Without a position it looks at the middle of all objects that have an end, from
 * where a picture of this aspect (width over height) shows their bounding sphere whole.
 */
export function frameObjects(scene: Scene, aspect: number): ResolvedCamera {
  const { up, fov } = { up: cameraTable.fields.up.default, fov: cameraTable.fields.fov.default, ...scene.camera };
  const { position, target } = scene.camera ?? {};
  const given = { up, fov, ...lensOf(scene.camera) };
  if (position) return { ...given, position, target: target ?? [0, 0, 0] };
  const { middle, radius } = boundingSphere(scene);
  const halfHeight = (fov * Math.PI) / 360;
  const narrower = Math.min(halfHeight, Math.atan(Math.tan(halfHeight) * aspect));
  const distance = (MARGIN * radius) / Math.sin(narrower);
  const lookAt = target ?? middle;
  return {
    ...given,
    position: addScaled(lookAt, VIEW_DIRECTION, distance + length(subtract(lookAt, middle))),
    target: lookAt,
  };
}

/** What makes the camera more than a pinhole that looks into a perspective. */
function lensOf({ type, height, aperture, focusDistance }: Partial<Camera> = {}): Partial<ResolvedCamera> {
  if (type === 'orthographic') return { type, ...(height === undefined ? {} : { height }) };
  return aperture ? { aperture, ...(focusDistance === undefined ? {} : { focusDistance }) } : {};
}

function boundingSphere(scene: Scene): { readonly middle: Vec3; readonly radius: number } {
  const boxes = flatScene(scene)
    .objects.map(({ shape }) => primitiveOf(shape).bounds(shape))
    .filter((box) => box !== undefined);
  if (boxes.length === 0) return { middle: [0, 0, 0], radius: 1 };
  const { min, max } = boxes.reduce(union);
  return { middle: scale(add(min, max), 0.5), radius: length(subtract(max, min)) / 2 };
}

const union = (a: Bounds, b: Bounds): Bounds => ({
  min: a.min.map((x, i) => Math.min(x, b.min[i] as number)) as unknown as Vec3,
  max: a.max.map((x, i) => Math.max(x, b.max[i] as number)) as unknown as Vec3,
});
