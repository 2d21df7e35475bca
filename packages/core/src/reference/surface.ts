/** Twin of shaders/surface.glsl: what the shading needs to know of the point that a ray met. */
import type { ResolvedScene } from '../resolve-scene.ts';
import type { Material } from '../schema.ts';
import { addScaled, dot, negate, type Vec3 } from '../vector.ts';
import { mapped } from './image-map.ts';
import type { Hit } from './nearest.ts';
import type { Ray } from './ray.ts';
import { tracedShape } from './shape/index.ts';

export interface Surface {
  readonly object: number;
  readonly position: Vec3;
  /** Unit length, on the side that the ray came from. */
  readonly normal: Vec3;
  /** Whether that is the outward side, or the front. */
  readonly front: boolean;
  /** Base colour here. */
  readonly color: Vec3;
  readonly material: Material;
}

export function surfaceAt(scene: ResolvedScene, ray: Ray, { object, t }: Hit): Surface {
  const { shape, material: index } = scene.objects[object] as ResolvedScene['objects'][number];
  const material = scene.materials[index] as Material;
  const position = addScaled(ray.origin, ray.direction, t);
  const outward = tracedShape(shape).normal(shape, position);
  const base = material.checker ? checkered(material, tracedShape(shape).lengths(shape, position)) : material.color;
  const front = dot(outward, ray.direction) <= 0;
  return {
    object,
    position,
    normal: front ? outward : negate(outward),
    front,
    color: mapped(scene, object, position, base),
    material,
  };
}

function checkered({ color, checker, checkerSize }: Material, [u, v]: readonly [number, number]): Vec3 {
  const odd = (Math.floor(u / checkerSize) + Math.floor(v / checkerSize)) % 2 !== 0;
  return (odd && checker) || color;
}
