/** Twin of shaders/vertex.glsl: a place where a path meets a surface, and what that does to light. */
import { dielectricReflectance, ggxAlpha } from '../material-record.ts';
import { primitiveOf } from '../parts.ts';
import type { ResolvedScene } from '../resolve-scene.ts';
import { dot, scale, type Vec3 } from '../vector.ts';
import { emitterRadiance } from './light/emitters.ts';
import type { Bsdf } from './material/bsdf.ts';
import { indexOf, leave, type Media } from './media.ts';
import type { Hit } from './nearest.ts';
import type { PathScene } from './path-scene.ts';
import type { Ray } from './ray.ts';
import { type Surface, surfaceAt } from './surface.ts';
import { type SurfaceFrame, surfaceFrame } from './surface-frame.ts';

export interface Vertex extends Surface {
  readonly frame: SurfaceFrame;
  /** Between the normal and the way that the ray came. */
  readonly cosine: number;
  /** Whether the object has an inside. */
  readonly closed: boolean;
}

export function vertexAt(scene: ResolvedScene, ray: Ray, hit: Hit): Vertex {
  const surface = surfaceAt(scene, ray, hit);
  const object = scene.objects[hit.object] as ResolvedScene['objects'][number];
  return {
    ...surface,
    frame: surfaceFrame(surface.normal),
    cosine: -dot(surface.normal, ray.direction),
    closed: primitiveOf(object.shape).closed,
  };
}

/** Radiance that the surface sends along -direction by itself. */
export function emittedRadiance(scene: PathScene, { object, material, front }: Vertex, direction: Vec3): Vec3 {
  const { emission, emissionIntensity, emissionSide } = material;
  if (emissionSide !== 'both' && (emissionSide === 'front') !== front) return [0, 0, 0];
  const emitter = scene.emitters[scene.emitterOf[object] ?? -1];
  return emitter ? emitterRadiance(emitter, direction) : scale(emission, emissionIntensity);
}

/** The material as light meets it here. */
export function bsdfAt(scene: ResolvedScene, { material, color, object, closed, front }: Vertex, media: Media): Bsdf {
  const { f0, f90 } = dielectricReflectance(material);
  return {
    color,
    alpha: ggxAlpha(material.roughness),
    f0,
    f90,
    metalness: material.metalness,
    specular: scale(material.specularColor, material.specular),
    transmission: material.transmission,
    eta: closed ? relativeIndex(scene, material.ior, media, object, front) : material.ior,
    thin: !closed,
  };
}

/** Index of refraction behind the surface over that in front. Within another medium entered later, there is no surface. */
function relativeIndex(scene: ResolvedScene, ior: number, media: Media, object: number, front: boolean): number {
  if (front) return ior / indexOf(scene, media);
  return indexOf(scene, leave(media, object)) / indexOf(scene, media);
}
