/** Twin of shaders/path.glsl: the integrator `path`, and what `direct` becomes where light is more than points. */

import { ROULETTE_FROM } from '../path-needs.ts';
import { type Sampler, sample2d } from '../random.ts';
import { add, addScaled, multiply, negate, scale, type Vec3 } from '../vector.ts';
import { background, type Rgba } from './background.ts';
import { type EmitterSample, emitterPdf, sampleEmitter } from './light/emitters.ts';
import { environmentRadiance } from './light/environment.ts';
import { type Bsdf, bsdfSample, bsdfValue, isMirrorOnly } from './material/bsdf.ts';
import { enter, leave, type Media, startMedia, transmittance } from './media.ts';
import { nearest, occluded } from './nearest.ts';
import type { PathScene } from './path-scene.ts';
import type { Ray } from './ray.ts';
import { toLocal, toWorld } from './surface-frame.ts';
import { bsdfAt, emittedRadiance, type Vertex, vertexAt } from './vertex.ts';

/** What is asked of random numbers at each scattering event, as in docs/light-transport.md. */
const SETS = { direction: 1, light: 2, choice: 3, roulette: 4, perEvent: 4 } as const;

/** How the ray that is under way was found: its pdf per solid angle, or 0 where no light could have been asked for it. */
interface Scattered {
  readonly from: Vec3;
  /** The object that it left. */
  readonly object: number | undefined;
  readonly pdf: number;
}

/** The radiance along a camera ray, of paths with up to `bounces` scattering events. */
export function path(scene: PathScene, cameraRay: Ray, bounces: number, sampler: Sampler): Rgba {
  let ray = cameraRay;
  let radiance: Vec3 = [0, 0, 0];
  let throughput: Vec3 = [1, 1, 1];
  let media = startMedia(scene);
  let scattered: Scattered = { from: ray.origin, object: undefined, pdf: 0 };
  let refraction = 1;
  for (let event = 0; ; event++) {
    const hit = nearest(scene, ray);
    if (!hit) {
      if (event === 0) return background(scene, ray.direction);
      return [...add(radiance, multiply(throughput, escaped(scene, ray.direction, scattered))), 1];
    }
    throughput = multiply(throughput, transmittance(scene, media, hit.t));
    const vertex = vertexAt(scene, ray, hit);
    const emission = scale(
      emittedRadiance(scene, vertex, ray.direction),
      emissionWeight(scene, vertex, ray, hit.t, scattered),
    );
    radiance = add(radiance, multiply(throughput, emission));
    if (event === bounces) return [...radiance, 1];

    const bsdf = bsdfAt(scene, vertex, media);
    const wo = toLocal(vertex.frame, negate(ray.direction));
    const [which, lobe] = sample2d(sampler, SETS.choice + SETS.perEvent * event);
    if (scene.emitters.length > 0 && !isMirrorOnly(bsdf)) {
      const place = sample2d(sampler, SETS.light + SETS.perEvent * event);
      const light = lightFrom(
        scene,
        vertex,
        bsdf,
        wo,
        media,
        sampleEmitter(scene, vertex.position, which, place, vertex.object),
      );
      radiance = add(radiance, multiply(throughput, light));
    }
    const onward = bsdfSample(bsdf, wo, sample2d(sampler, SETS.direction + SETS.perEvent * event), lobe);
    throughput = multiply(throughput, onward.weight);
    if (!throughput.some((channel) => channel > 0)) return [...radiance, 1];
    if (onward.wi[2] < 0 && vertex.closed) {
      media = vertex.front ? enter(media, vertex.object) : leave(media, vertex.object);
      refraction *= bsdf.eta * bsdf.eta;
    }
    if (event >= ROULETTE_FROM) {
      const survival = Math.min(1, Math.max(...throughput) * refraction);
      if (sample2d(sampler, SETS.roulette + SETS.perEvent * event)[0] >= survival) return [...radiance, 1];
      throughput = scale(throughput, 1 / survival);
    }
    scattered = { from: vertex.position, object: vertex.object, pdf: onward.pdf };
    ray = { origin: vertex.position, direction: toWorld(vertex.frame, onward.wi), own: vertex.object };
  }
}

/** Veach's power heuristic with exponent 2: the weight of a direction that was found with pdf `a` and not with `b`. */
export function powerHeuristic(a: number, b: number): number {
  // As a quotient, so that nothing is squared that would leave the range.
  if (a >= b) return a > 0 ? 1 / (1 + (b / a) ** 2) : 0;
  const ratio = a / b;
  return (ratio * ratio) / (1 + ratio * ratio);
}

/** The light of one emitter by way of a surface, weighted against what the BSDF would have found. */
function lightFrom(
  scene: PathScene,
  { position, object, frame, front, closed }: Vertex,
  bsdf: Bsdf,
  wo: Vec3,
  media: Media,
  light: EmitterSample | undefined,
): Vec3 {
  if (!light || !(light.pdf > 0)) return [0, 0, 0];
  const wi = toLocal(frame, light.direction);
  const { value, pdf } = bsdfValue(bsdf, wo, wi);
  if (!value.some((channel) => channel > 0)) return [0, 0, 0];
  const shadowRay = { origin: position, direction: light.direction, own: object };
  if (occluded(scene, shadowRay, light.distance, light.object)) return [0, 0, 0];
  const beyond = wi[2] < 0 && closed ? (front ? enter(media, object) : leave(media, object)) : media;
  const weight = light.delta ? 1 : powerHeuristic(light.pdf, pdf);
  const arriving = multiply(light.radiance, transmittance(scene, beyond, light.distance));
  return scale(multiply(value, arriving), weight / light.pdf);
}

/** The weight of emission that a ray met: how the same might have been found by asking for light. */
function emissionWeight(
  scene: PathScene,
  vertex: Vertex,
  ray: Ray,
  t: number,
  { from, object, pdf }: Scattered,
): number {
  const emitter = scene.emitterOf[vertex.object];
  if (pdf === 0 || emitter === undefined) return 1;
  return powerHeuristic(pdf, emitterPdf(scene, emitter, from, ray.direction, t, vertex.cosine, object));
}

/** What comes from infinitely far away: the surroundings, and the suns that the direction points into. */
function escaped(scene: PathScene, direction: Vec3, { from, pdf }: Scattered): Vec3 {
  const surroundings: Vec3 = scene.environment ? environmentRadiance(scene.environment, direction) : [0, 0, 0];
  return scene.emitters.reduce((sum, emitter, i): Vec3 => {
    if (emitter.kind !== 'sun') return sum;
    const asked = emitterPdf(scene, i, from, direction, Number.POSITIVE_INFINITY, 1);
    return asked > 0 ? addScaled(sum, emitter.radiance, pdf === 0 ? 1 : powerHeuristic(pdf, asked)) : sum;
  }, surroundings);
}
