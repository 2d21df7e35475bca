/** Twin of shaders/light/emitters.glsl: asking one emitter of a scene for the light that it sends to a point. */

import type { Affine } from '../../affine.ts';
import { type AliasTable, choose } from '../../emitter-table.ts';
import type { Emitter, EmitterOf } from '../../emitters.ts';
import { addScaled, type Vec3 } from '../../vector.ts';
import { boxPdf, boxSample } from './emitter/box.ts';
import { cylinderPdf, cylinderSample } from './emitter/cylinder.ts';
import { directionalSample } from './emitter/directional.ts';
import { discPdf, discSample } from './emitter/disc.ts';
import { imagePdf, imageRadiance, imageSample } from './emitter/image.ts';
import { ownCosine } from './emitter/own-cosine.ts';
import { rayInOwnSpace, sampleFromOwnSpace } from './emitter/own-space.ts';
import { pointSample } from './emitter/point.ts';
import { quadPdf, quadSample } from './emitter/quad.ts';
import type { EmitterSample } from './emitter/sample.ts';
import { spherePdf, sphereRadiance, sphereSample } from './emitter/sphere.ts';
import { spotSample } from './emitter/spot.ts';
import { sunPdf, sunSample } from './emitter/sun.ts';
import { trianglePdf, triangleSample } from './emitter/triangle.ts';

export type { EmitterSample } from './emitter/sample.ts';

/** What can be asked for light, and how one of it is chosen. */
export interface Lighting {
  readonly emitters: readonly Emitter[];
  readonly table: AliasTable;
}

/** One of an emitter's directions from a point p, which is on the object `own` if `own` is given. */
type Sample<E> = (emitter: E, p: Vec3, u: readonly [number, number], own: boolean) => EmitterSample | undefined;

/**
 * One emitter by way of `which`, and one direction to it by way of u, both from [0, 1); undefined where no direction
 * leads to it. `own` is the object whose surface p is on: of that, only what is across its inside is seen.
 */
export function sampleEmitter(
  { emitters, table }: Lighting,
  p: Vec3,
  which: number,
  u: readonly [number, number],
  own?: number,
): EmitterSample | undefined {
  const index = choose(table, which);
  const emitter = emitters[index];
  const probability = table.probabilities[index] as number;
  if (!emitter || probability === 0) return undefined;
  const sample = sampleOf(emitter, p, u, own);
  return sample && { ...sample, pdf: sample.pdf * probability };
}

/** One of the directions to an emitter, by way of u; undefined where none leads to it. */
export function sampleOf(
  emitter: Emitter,
  p: Vec3,
  u: readonly [number, number],
  own?: number,
): EmitterSample | undefined {
  const place = placeOf(emitter);
  const from = place ? place.pointBack(p) : p;
  const sample = (samples[emitter.kind] as Sample<Emitter>)(emitter, from, u, isObject(emitter, own));
  if (!sample || !(sample.pdf > 0)) return undefined;
  return place ? sampleFromOwnSpace(place, sample) : sample;
}

const placeOf = (emitter: Emitter): Affine | undefined => ('place' in emitter ? emitter.place : undefined);

/**
 * The pdf, per solid angle, with which `sampleEmitter` finds a direction; that direction meets the emitter at the
 * distance t from `from`, under an angle of this cosine with the normal. 0 for what has no extent, which no ray meets.
 */
export function emitterPdf(
  { emitters, table }: Lighting,
  index: number,
  from: Vec3,
  direction: Vec3,
  t: number,
  cosine: number,
  own?: number,
): number {
  const emitter = emitters[index];
  if (!emitter) return 0;
  return (table.probabilities[index] as number) * pdfOf(emitter, from, direction, t, cosine, isObject(emitter, own));
}

function pdfOf(emitter: Emitter, from: Vec3, d: Vec3, t: number, cosine: number, own: boolean): number {
  const place = placeOf(emitter);
  if (!place) return onePdf(emitter, from, d, t, cosine, own);
  const ray = rayInOwnSpace(place, from, d, t);
  const met = ownCosine(emitter, addScaled(ray.from, ray.d, ray.t), ray.d);
  return onePdf(emitter, ray.from, ray.d, ray.t, met, own) / ray.density;
}

/** The radiance that an emitter sends along -direction; a ray with that direction has met it. */
export function emitterRadiance(emitter: Emitter, direction: Vec3): Vec3 {
  if (emitter.kind === 'sphere') return sphereRadiance(emitter, direction);
  if (emitter.kind === 'image') return imageRadiance(emitter, direction);
  return 'radiance' in emitter ? emitter.radiance : [0, 0, 0];
}

const isObject = (emitter: Emitter, own: number | undefined): boolean => 'object' in emitter && emitter.object === own;

const samples: { readonly [K in Emitter['kind']]: Sample<EmitterOf<K>> } = {
  point: pointSample,
  spot: spotSample,
  directional: directionalSample,
  sun: sunSample,
  sphere: sphereSample,
  quad: quadSample,
  disc: discSample,
  triangle: triangleSample,
  box: boxSample,
  cylinder: cylinderSample,
  image: imageSample,
};

function onePdf(emitter: Emitter, from: Vec3, d: Vec3, t: number, cosine: number, own: boolean): number {
  switch (emitter.kind) {
    case 'sun':
      return sunPdf(emitter, d);
    case 'sphere':
      return spherePdf(emitter, from, d, own);
    case 'quad':
      return quadPdf(emitter, from, t, cosine);
    case 'disc':
      return discPdf(emitter, t, cosine);
    case 'triangle':
      return trianglePdf(emitter, t, cosine);
    case 'box':
      return boxPdf(emitter, from, t, cosine, own);
    case 'cylinder':
      return cylinderPdf(emitter, from, t, cosine, own);
    case 'image':
      return imagePdf(emitter, d);
    default:
      return 0;
  }
}
