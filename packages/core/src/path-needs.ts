/** What the integrator `path` asks of a scene, beyond what its nodes say by themselves. */
import { emitterFeatures } from './emitter-record.ts';
import { sceneEmitters } from './emitters.ts';
import type { Feature } from './features.ts';
import { countGlints, GLINT_FEATURES } from './glints.ts';
import { mappedKinds } from './image-map.ts';
import { ggxAlpha } from './material-record.ts';
import { primitiveOf } from './parts.ts';
import { rayStart } from './ray-start.ts';
import { hasChecker } from './requirements.ts';
import { isEmissive, type ResolvedObject, type ResolvedScene } from './resolve-scene.ts';
import { isSurfaceOutput, type SceneNeeds, type Tracing } from './scene-needs.ts';
import type { Material } from './schema.ts';

export function pathNeeds(
  scene: ResolvedScene,
  { clamp }: Partial<Tracing> = {},
): { readonly features: readonly Feature[]; readonly emitters: number } {
  const { camera, materials, objects, around } = scene;
  const emitters = sceneEmitters(scene);
  const materialOf = ({ material }: ResolvedObject): Material => materials[material] as Material;
  const transmissive = objects.filter((object) => materialOf(object).transmission > 0);
  const solid = transmissive.filter(({ shape }) => primitiveOf(shape).closed);
  const emissive = materials.filter(isEmissive);
  const mapped = mappedKinds(scene);
  const facts: { readonly [F in Feature]?: boolean } = {
    rough: materials.some((one) => hasFacets(one) && ggxAlpha(one.roughness) > 0),
    smooth: materials.some((one) => hasFacets(one) && ggxAlpha(one.roughness) === 0),
    opaqueBase: materials.some(({ metalness, transmission }) => metalness < 1 && transmission < 1),
    thin: transmissive.length > solid.length,
    solid: solid.length > 0,
    nested: solid.length > 1 || around.length > 0,
    attenuation: solid.some((object) => !!materialOf(object).attenuationDistance),
    emissive: emissive.length > 0,
    sides: solid.length > 0 || emissive.length > 0,
    map: mapped.length > 0,
    clamp: clamp !== undefined,
    lens: !!camera.aperture && camera.type !== 'orthographic',
    distant: camera.type === 'orthographic' || rayStart(scene) > 0,
  };
  return {
    features: [
      ...GLINT_FEATURES.slice(0, countGlints(scene, emitters)),
      ...(Object.keys(facts) as Feature[]).filter((feature) => facts[feature]),
      ...mapped.map((kind) => `${kind}Map` as const),
      ...emitterFeatures(emitters),
    ],
    emitters: emitters.length,
  };
}

/** Whether a material reflects or refracts at its surface, besides what it scatters below. */
const hasFacets = ({ metalness, specular, transmission }: Material): boolean =>
  metalness > 0 || specular > 0 || transmission > 0;

/** How many events pass before roulette may end a path. */
export const ROULETTE_FROM = 3;

/** What paths need of all that the nodes bring with them. */
export function pathFeatures({ bounces, shapes, placed, emitters, features: given }: SceneNeeds): Set<Feature> {
  const present = new Set(given);
  const has = (feature: Feature): boolean => present.has(feature);
  const set = (feature: Feature, needed: boolean): unknown => (needed ? present.add(feature) : present.delete(feature));
  set('through', true);
  set('indexed', true);
  set('closeSphere', shapes.sphere + placed.sphere > 0);
  set('specular', has('specular') && has('dielectric'));
  for (const detail of ['specularTint', 'specularWeight'] as const) set(detail, has(detail) && has('specular'));
  set('reflective', has('metal') || has('specular') || has('transmission'));
  set('shadows', emitters > 0);
  set('sharedPlace', has('whitted') || [...present].some(isSurfaceOutput));
  set('severalEmitters', emitters > 1 && !has('whitted'));
  if (has('whitted')) set('smooth', has('reflective'));
  // The second event is at the ball.
  for (const glint of GLINT_FEATURES) set(glint, has(glint) && bounces > 1 && !has('whitted'));
  set('roulette', bounces > ROULETTE_FROM && !has('whitted'));
  set('checker', hasChecker(present));
  set('turnedChecker', has('turnedChecker') && has('planeChecker'));
  for (const unused of ['falloff', 'noFalloff', 'inside'] as const) set(unused, false);
  set('tiltedPlane', has('tiltedPlane') && shapes.plane + placed.plane > 0);
  set('exactRays', has('exactRays') && !has('distant'));
  return present;
}
