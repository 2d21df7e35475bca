/** Twin of shaders/output.glsl: what is shown of the first surface that a camera ray meets, in place of its light. */
import type { CameraFrame } from '../camera-frame.ts';
import type { ResolvedScene } from '../resolve-scene.ts';
import type { RenderSettings } from '../settings.ts';
import { dot, subtract, type Vec3 } from '../vector.ts';
import { nearest } from './nearest.ts';
import type { Ray } from './ray.ts';
import { surfaceAt } from './surface.ts';

/** Linear, RGBA. At the distance of what is in focus, depth is half bright. */
export function firstSurface(
  scene: ResolvedScene,
  ray: Ray,
  output: RenderSettings['output'],
  { origin, lens, focus }: CameraFrame,
): readonly [number, number, number, number] {
  const hit = nearest(scene, ray);
  if (!hit) return [0, 0, 0, 0];
  const { normal, color } = surfaceAt(scene, ray, hit);
  if (output === 'albedo') return [...color, 1];
  // Rays from a lens are that long; others start at the camera, or straight ahead of where they would.
  const toStart = lens ? 0 : dot(subtract(ray.origin, origin), ray.direction);
  const depth = focus / (focus + toStart + hit.t);
  const encoded = output === 'depth' ? ([depth, depth, depth] as const) : normal.map((x) => 0.5 * x + 0.5);
  return [...(encoded.map(decodeSrgb) as unknown as Vec3), 1];
}

/** Source: IEC 61966-2-1:1999, section 5.2. */
const decodeSrgb = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
