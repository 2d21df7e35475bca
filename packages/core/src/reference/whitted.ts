/** Twin of shaders/whitted.glsl: the integrator `direct` where light is more than points, or goes through surfaces. */
import { add, multiply, scale, type Vec3 } from '../vector.ts';
import { sampleOf } from './light/emitters.ts';
import { environmentIrradiance } from './light/environment.ts';
import { lightBy } from './light-by.ts';
import { type Bsdf, type BsdfSample, bsdfSample } from './material/bsdf.ts';
import { facetProbability, splitAt } from './material/fresnel.ts';
import type { PathScene } from './path-scene.ts';
import type { Vertex } from './vertex.ts';

/** The light of all lights, and of the surroundings by the diffuse part alone, without shadows. */
export function lightOfAll(scene: PathScene, vertex: Vertex, bsdf: Bsdf, wo: Vec3, u: readonly [number, number]): Vec3 {
  const fromLights = scene.emitters
    .map((emitter) => lightBy(scene, vertex, bsdf, wo, sampleOf(emitter, vertex.position, u, vertex.object)))
    .reduce(add, [0, 0, 0]);
  if (!scene.environment) return fromLights;
  const irradiance = environmentIrradiance(scene.environment, vertex.normal);
  return add(fromLights, multiply(splitAt(bsdf, wo[2]).diffuse, irradiance));
}

/** On as from a smooth surface. The pdf tells whether lights could be asked for what is there. */
export function mirrorSample(bsdf: Bsdf, wo: Vec3, chance: number): BsdfSample {
  const facets = facetProbability(bsdf, wo[2]);
  if (facets === 0) return { wi: wo, weight: [0, 0, 0], pdf: 0 };
  const onward = bsdfSample({ ...bsdf, alpha: 0 }, wo, [0.5, 0.5], chance * facets);
  return { wi: onward.wi, weight: scale(onward.weight, facets), pdf: bsdf.alpha > 0 ? 1 : 0 };
}
