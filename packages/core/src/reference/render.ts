/** The reference renderer: the same rays and the same random numbers as the shader, in f64. */
import { cameraFrame, rayDirection } from '../camera-frame.ts';
import { pixelSample } from '../random.ts';
import { resolveScene } from '../resolve-scene.ts';
import type { Scene } from '../schema.ts';
import { parseSettings, type RenderSettings } from '../settings.ts';
import { normalize, type Vec3 } from '../vector.ts';
import { direct } from './direct.ts';

export interface ReferenceSettings extends Partial<RenderSettings> {
  /** In pixels. */
  readonly width: number;
  readonly height: number;
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
  const { width, height, nudge = [0, 0, 0], ...rest } = settings;
  const { samples, seed, bounces } = parseSettings(rest);
  const resolved = resolveScene(scene, width / height);
  const data = new Float64Array(width * height * 4);
  for (let sample = 0; sample < samples; sample++) {
    const frame = cameraFrame(resolved.camera, width, height, pixelSample(sample, seed));
    for (let pixel = 0; pixel < width * height; pixel++) {
      const [x, row] = [pixel % width, Math.floor(pixel / width)];
      const direction = nudged(normalize(rayDirection(frame, x + 0.5, height - row - 0.5)), nudge);
      const rgba = direct(resolved, { origin: frame.origin, direction }, bounces);
      rgba.forEach((value, i) => {
        data[4 * pixel + i] = (data[4 * pixel + i] as number) + value / samples;
      });
    }
  }
  return { width, height, data };
}

const nudged = (direction: Vec3, ulps: Vec3): Vec3 =>
  direction.map((x, i) => x + (ulps[i] as number) * ulp32(x)) as unknown as Vec3;

/** The distance between neighbouring f32 numbers at x. */
const ulp32 = (x: number): number => 2 ** (Math.floor(Math.log2(Math.max(Math.abs(x), 2 ** -126))) - 23);
