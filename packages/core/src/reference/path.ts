/** Twin of shaders/path.glsl: the integrator `path`, and what `direct` becomes where light is more than points. */

import { ROULETTE_FROM } from '../path-needs.ts';
import { type Sampler, sample2d } from '../random.ts';
import { add, addScaled, dot, multiply, negate, scale, type Vec3 } from '../vector.ts';
import { background, type Rgba } from './background.ts';
import { type Glints, glintsAt, NO_GLINTS, sampleWithGlints } from './glint.ts';
import { type EmitterSample, emitterPdf, emitterRadiance, sampleEmitter } from './light/emitters.ts';
import { environmentRadiance } from './light/environment.ts';
import { lightBy, powerHeuristic } from './light-by.ts';
import { type Bsdf, type BsdfSample, isMirrorOnly } from './material/bsdf.ts';
import { enter, leave, type Media, startMedia, transmittance } from './media.ts';
import { nearest } from './nearest.ts';
import type { PathScene } from './path-scene.ts';
import type { Ray } from './ray.ts';
import { toLocal, toWorld } from './surface-frame.ts';
import { bsdfAt, emittedRadiance, type Vertex, vertexAt } from './vertex.ts';
import { lightOfAll, mirrorSample } from './whitted.ts';

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
  // What shines where the camera sees it.
  let seen: Vec3 = [0, 0, 0];
  const total = (): Rgba => [...add(seen, dimmed(radiance, scene.clamp)), 1];
  for (let event = 0; ; event++) {
    const hit = nearest(scene, ray);
    if (!hit) {
      if (event === 0) return backdrop(scene, ray.direction);
      radiance = add(radiance, multiply(throughput, escaped(scene, ray.direction, scattered)));
      return total();
    }
    throughput = multiply(throughput, transmittance(scene, media, hit.t));
    const vertex = vertexAt(scene, ray, hit);
    const emission = scale(
      emittedRadiance(scene, vertex, ray.direction),
      emissionWeight(scene, vertex, ray, hit.t, scattered),
    );
    radiance = add(radiance, multiply(throughput, emission));
    if (event === 0) [seen, radiance] = [radiance, [0, 0, 0]];
    if (event === bounces) return total();

    const bsdf = bsdfAt(scene, vertex, media);
    const wo = toLocal(vertex.frame, negate(ray.direction));
    // Beyond the next surface, light must still be asked for.
    const glints = event + 1 < bounces ? glintsAt(scene, vertex, bsdf, wo) : NO_GLINTS;
    if (scene.whitted) {
      const place = sample2d(sampler, SETS.light + SETS.perEvent * event);
      radiance = add(radiance, multiply(throughput, lightOfAll(scene, vertex, bsdf, wo, place)));
    } else if (scene.emitters.length > 0 && !isMirrorOnly(bsdf)) {
      const light = attenuated(scene, vertex, media, lightAsked(scene, vertex, sampler, event));
      radiance = add(radiance, multiply(throughput, lightBy(scene, vertex, bsdf, wo, light, glints)));
    }
    const onward = scene.whitted
      ? mirrorSample(bsdf, wo, sample2d(sampler, SETS.roulette + SETS.perEvent * event)[1])
      : scatter(bsdf, wo, glints, sampler, event);
    throughput = multiply(throughput, onward.weight);
    if (!throughput.some((channel) => channel > 0)) return total();
    if (onward.wi[2] < 0 && vertex.closed) {
      media = vertex.front ? enter(media, vertex.object) : leave(media, vertex.object);
      refraction *= bsdf.eta * bsdf.eta;
    }
    if (event >= ROULETTE_FROM && !scene.whitted) {
      const survival = Math.min(1, Math.max(...throughput) * refraction);
      if (sample2d(sampler, SETS.roulette + SETS.perEvent * event)[0] >= survival) return total();
      throughput = scale(throughput, 1 / survival);
    }
    scattered = { from: vertex.position, object: vertex.object, pdf: onward.pdf };
    ray = { origin: vertex.position, direction: toWorld(vertex.frame, onward.wi), own: vertex.object };
  }
}

/** Dimmed, not cut channel by channel: its colour stays. */
const dimmed = (radiance: Vec3, most: number): Vec3 => {
  const largest = Math.max(...radiance);
  return largest > most ? scale(radiance, most / largest) : radiance;
};

/** One light, chosen at random, that is asked at an event. */
function lightAsked(scene: PathScene, { position, object }: Vertex, sampler: Sampler, event: number) {
  const [which] = sample2d(sampler, SETS.choice + SETS.perEvent * event);
  return sampleEmitter(scene, position, which, sample2d(sampler, SETS.light + SETS.perEvent * event), object);
}

/** What is left of its light after the way through the medium on its side of the surface. */
function attenuated(
  scene: PathScene,
  { normal, object, front, closed }: Vertex,
  media: Media,
  light: EmitterSample | undefined,
): EmitterSample | undefined {
  if (!light) return undefined;
  const isBehind = dot(normal, light.direction) < 0 && closed;
  const beyond = isBehind ? (front ? enter(media, object) : leave(media, object)) : media;
  return { ...light, radiance: multiply(light.radiance, transmittance(scene, beyond, light.distance)) };
}

function scatter(bsdf: Bsdf, wo: Vec3, glints: Glints, sampler: Sampler, event: number): BsdfSample {
  const [, lobe] = sample2d(sampler, SETS.choice + SETS.perEvent * event);
  return sampleWithGlints(bsdf, wo, glints, sample2d(sampler, SETS.direction + SETS.perEvent * event), lobe);
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
  return powerHeuristic(scene, pdf, emitterPdf(scene, emitter, from, ray.direction, t, vertex.cosine, object));
}

/** What a camera ray shows that meets nothing; an image, on top of black. */
function backdrop(scene: PathScene, direction: Vec3): Rgba {
  const [r, g, b, alpha] = background(scene, direction);
  const image = scene.background === 'environment' && scene.emitters.find(({ kind }) => kind === 'image');
  return image ? [...add([r, g, b], emitterRadiance(image, direction)), alpha] : [r, g, b, alpha];
}

/** What comes from infinitely far away: the surroundings, and the suns that the direction points into. */
function escaped(scene: PathScene, direction: Vec3, { from, pdf }: Scattered): Vec3 {
  const surroundings: Vec3 = scene.environment ? environmentRadiance(scene.environment, direction) : [0, 0, 0];
  return scene.emitters.reduce((sum, emitter, i): Vec3 => {
    if (emitter.kind !== 'sun' && emitter.kind !== 'image') return sum;
    const asked = emitterPdf(scene, i, from, direction, Number.POSITIVE_INFINITY, 1);
    // A sun is where it is found, an image everywhere.
    if (emitter.kind === 'sun' && !(asked > 0)) return sum;
    const weight = pdf === 0 ? 1 : powerHeuristic(scene, pdf, asked);
    return addScaled(sum, emitterRadiance(emitter, direction), weight);
  }, surroundings);
}
