/** Twin of shaders/direct.glsl: Whitted's integrator. */
import type { ResolvedScene } from '../resolve-scene.ts';
import { add, addScaled, dot, multiply, negate, type Vec3 } from '../vector.ts';
import { background, type Rgba } from './background.ts';
import { environmentIrradiance, environmentRadiance } from './light/environment.ts';
import { lightArriving } from './light/lights.ts';
import { diffuseAlbedo, fresnel, scattered, schlickWeight } from './material/metallic-roughness.ts';
import { nearest, occluded } from './nearest.ts';
import type { Ray } from './ray.ts';
import { type Surface, surfaceAt } from './surface.ts';

/** The radiance along a camera ray: of up to `bounces` surfaces, each lit directly, one seen in the other. */
export function direct(scene: ResolvedScene, cameraRay: Ray, bounces: number): Rgba {
  let ray = cameraRay;
  let radiance: Vec3 = [0, 0, 0];
  let throughput: Vec3 = [1, 1, 1];
  for (let bounce = 0; ; bounce++) {
    const hit = nearest(scene, ray);
    if (!hit) {
      if (bounce === 0) return background(scene, ray.direction);
      if (scene.environment) {
        radiance = add(radiance, multiply(throughput, environmentRadiance(scene.environment, ray.direction)));
      }
    }
    if (!hit || bounce === bounces) return [...radiance, 1];
    const surface = surfaceAt(scene, ray, hit);
    const v = negate(ray.direction);
    radiance = add(radiance, multiply(throughput, reflected(scene, surface, v)));
    const weight = schlickWeight(dot(surface.normal, v));
    throughput = multiply(throughput, fresnel(surface, weight));
    ray = { origin: surface.position, direction: mirrored(ray.direction, surface.normal), own: hit.object };
  }
}

/** The light of all lights that a surface sends towards the eye. */
function reflected(scene: ResolvedScene, surface: Surface, v: Vec3): Vec3 {
  const { normal, position, object } = surface;
  const lit = scene.lights.map((light): Vec3 => {
    const { direction, distance, irradiance } = lightArriving(light, position);
    if (!(dot(normal, direction) > 0)) return [0, 0, 0];
    if (occluded(scene, { origin: position, direction, own: object }, distance)) return [0, 0, 0];
    return multiply(irradiance, scattered(surface, v, direction));
  });
  const fromLights = lit.reduce(add, [0, 0, 0]);
  if (!scene.environment) return fromLights;
  const albedo = diffuseAlbedo(surface, schlickWeight(dot(normal, v)));
  return add(fromLights, multiply(albedo, environmentIrradiance(scene.environment, normal)));
}

const mirrored = (d: Vec3, n: Vec3): Vec3 => addScaled(d, n, -2 * dot(d, n));
