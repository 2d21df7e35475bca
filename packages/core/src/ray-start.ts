/**
 * Where camera rays start. From a million times as far away as what it sees is large, f32 does not tell the directions of
 * neighbouring pixels apart; but it tells their points in a plane just before the nearest object.
 */
import { cameraAxes, NARROW_FOV } from './camera-frame.ts';
import { primitiveOf } from './parts.ts';
import { planeAxes } from './primitives/plane.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { Shape } from './schema.ts';
import { add, addScaled, dot, length, scale, subtract, type Vec3 } from './vector.ts';

/** Pictures that are more than this times as wide as high might miss a plane at their sides. */
const WIDEST = 16;

/**
 * How far ahead of the camera the plane is in which its rays start: all that can be seen is behind it. 0 where they start
 * at the camera itself or its lens, as they do unless it looks through a narrow pinhole or an orthographic view.
 */
export function rayStart({ camera, objects }: Pick<ResolvedScene, 'camera' | 'objects'>): number {
  const { type, aperture = 0, fov } = camera;
  const orthographic = type === 'orthographic';
  if (!orthographic && (aperture > 0 || fov >= NARROW_FOV)) return 0;
  const { forward } = cameraAxes(camera);
  // How far from the axis rays get, by what they have gone; twice that, so that there is room before the plane.
  const slope = orthographic ? Number.POSITIVE_INFINITY : 2 * WIDEST * Math.tan((fov * Math.PI) / 360);
  const depths = objects.map(({ shape }) => {
    const box = primitiveOf(shape).bounds(shape);
    // What has no end is a plane.
    if (!box) return shape.place ? 0 : depthOfPlane(shape as Shape<'plane'>, camera.position, forward, slope);
    const depth = dot(forward, subtract(scale(add(box.min, box.max), 0.5), camera.position));
    // Twice the radius of a sphere around the box, so that there is room before it.
    const reach = length(subtract(box.max, box.min));
    return depth < -reach ? Number.POSITIVE_INFINITY : depth - reach;
  });
  const nearest = Math.min(...depths);
  return nearest > 0 && nearest < Number.POSITIVE_INFINITY ? nearest : 0;
}

/** No ray meets the plane at a lesser depth, whose slope against the axis is no more than this. */
function depthOfPlane(shape: Shape<'plane'>, eye: Vec3, forward: Vec3, slope: number): number {
  const { normal } = planeAxes(shape);
  const height = dot(normal, subtract(shape.point, eye));
  const descent = Math.sign(height) * dot(normal, forward) + slope;
  return descent > 0 ? Math.abs(height) / descent : Number.POSITIVE_INFINITY;
}

/** The point on the axis where that is: the origin of the space that the scene is packed in. */
export const packingOrigin = (scene: Pick<ResolvedScene, 'camera' | 'objects'>): Vec3 =>
  addScaled(scene.camera.position, cameraAxes(scene.camera).forward, rayStart(scene));
