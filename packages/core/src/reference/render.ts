/** The reference renderer: the same rays and the same random numbers as the shader, in f64. */
import { type CameraFrame, cameraFrame, cameraRay } from '../camera-frame.ts';
import { ownPlace, pixelSample, pixelSampler, type Sampler, sample2d } from '../random.ts';
import { rayStart } from '../ray-start.ts';
import { type EnvironmentImages, resolveScene } from '../resolve-scene.ts';
import { followsPaths, isSurfaceOutput } from '../scene-needs.ts';
import type { Scene } from '../schema.ts';
import { parseSettings, type RenderSettings } from '../settings.ts';
import { add, type Vec3 } from '../vector.ts';
import { circle } from './circle.ts';
import { direct } from './direct.ts';
import { firstSurface } from './output.ts';
import { path } from './path.ts';
import { preparePaths } from './path-scene.ts';
import type { Ray } from './ray.ts';

export interface ReferenceSettings extends Partial<RenderSettings> {
  /** In pixels. */
  readonly width: number;
  readonly height: number;
  /** Of the surroundings, by their addresses in the scene. */
  readonly images?: EnvironmentImages;
  /** Moves each component of every camera ray's unit direction by so many ulps of f32. */
  readonly nudge?: Vec3;
}

export interface ReferenceImage {
  readonly width: number;
  readonly height: number;
  /** Mean linear radiance, RGBA premultiplied by coverage, top row first. */
  readonly data: Float64Array;
}

/**
 * Renders a scene in f64.
 * @throws {SceneError} when a setting is unknown or out of its range.
 */
export function renderReference(scene: Scene, settings: ReferenceSettings): ReferenceImage {
  const { width, height, images, nudge = [0, 0, 0], ...rest } = settings;
  const { samples, seed, bounces, integrator, output, clamp } = parseSettings(rest);
  const resolved = resolveScene(scene, width / height, undefined, images);
  const paths = followsPaths(resolved, { integrator }) ? preparePaths(resolved, integrator, clamp) : undefined;
  const hasOwnPlaces = integrator === 'path' && !isSurfaceOutput(output);
  const frame = cameraFrame(resolved.camera, width, height);
  const ahead = rayStart(resolved);
  const data = new Float64Array(width * height * 4);
  for (let sample = 0; sample < samples; sample++) {
    const shared = hasOwnPlaces ? undefined : pixelSample(sample, seed);
    for (let pixel = 0; pixel < width * height; pixel++) {
      const [x, row] = [pixel % width, Math.floor(pixel / width)];
      const y = height - 1 - row;
      const sampler = pixelSampler(x, y, sample, seed);
      const [right, down] = shared ?? ownPlace(sampler);
      const ray = nudged(rayThrough(frame, x + right, y + 1 - down, sampler, ahead), nudge);
      const rgba = isSurfaceOutput(output)
        ? firstSurface(resolved, ray, output, frame)
        : paths
          ? path(paths, ray, bounces, sampler)
          : direct(resolved, ray, bounces);
      rgba.forEach((value, i) => {
        data[4 * pixel + i] = (data[4 * pixel + i] as number) + value / samples;
      });
    }
  }
  return { width, height, data };
}

function rayThrough(frame: CameraFrame, x: number, y: number, sampler: Sampler, ahead: number): Ray {
  const [angle, area] = frame.lens ? sample2d(sampler, LENS_SET) : [0, 0];
  const [right, up] = circle(angle);
  const onLens = [right * Math.sqrt(area), up * Math.sqrt(area)] as const;
  const { start, direction } = cameraRay(frame, x, y, onLens, ahead);
  return { origin: add(frame.origin, start), direction };
}

/** The random numbers of the place on the lens. */
const LENS_SET = 0;

const nudged = ({ origin, direction }: Ray, ulps: Vec3): Ray => ({
  origin,
  direction: direction.map((x, i) => x + (ulps[i] as number) * ulp32(x)) as unknown as Vec3,
});

/** The distance between neighbouring f32 numbers at x. */
const ulp32 = (x: number): number => 2 ** (Math.floor(Math.log2(Math.max(Math.abs(x), 2 ** -126))) - 23);
