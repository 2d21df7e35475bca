/** The light of an emitter by way of a surface; of shaders/path.glsl. */
import { multiply, scale, type Vec3 } from '../vector.ts';
import { NO_GLINTS, pdfWithGlints } from './glint.ts';
import type { EmitterSample } from './light/emitters.ts';
import { type Bsdf, bsdfValue } from './material/bsdf.ts';
import { occluded } from './nearest.ts';
import type { PathScene } from './path-scene.ts';
import { toLocal } from './surface-frame.ts';
import type { Vertex } from './vertex.ts';

/**
 * Veach's power heuristic with exponent 2: the weight of a direction that was found with pdf `a` and not with `b`. Where
 * all lights are asked at every surface, what they are asked for is not found again.
 */
export function powerHeuristic({ whitted }: PathScene, a: number, b: number): number {
  if (whitted) return 0;
  // As a quotient, so that nothing is squared that would leave the range.
  const square = (Math.min(a, b) / Math.max(a, b)) ** 2;
  return (a < b ? square : 1) / (1 + square);
}

/** Weighted against how the path might have found it by going on. */
export function lightBy(
  scene: PathScene,
  { position, object, frame }: Vertex,
  bsdf: Bsdf,
  wo: Vec3,
  light: EmitterSample | undefined,
  glints = NO_GLINTS,
): Vec3 {
  if (!light || !(light.pdf > 0)) return [0, 0, 0];
  const wi = toLocal(frame, light.direction);
  const { value, pdf } = bsdfValue(bsdf, wo, wi);
  if (!value.some((channel) => channel > 0)) return [0, 0, 0];
  const shadowRay = { origin: position, direction: light.direction, own: object };
  if (occluded(scene, shadowRay, light.distance, light.object)) return [0, 0, 0];
  const weight = light.delta || scene.whitted ? 1 : powerHeuristic(scene, light.pdf, pdfWithGlints(glints, wi, pdf));
  return scale(multiply(value, light.radiance), weight / light.pdf);
}
