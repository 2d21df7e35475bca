/** What the integrator `path` asks of a scene, beyond what its nodes say by themselves. */
import { emitterFeatures } from './emitter-record.ts';
import { sceneEmitters } from './emitters.ts';
import { ggxAlpha } from './material-record.ts';
import { primitiveOf } from './parts.ts';
import { isEmissive, type ResolvedObject, type ResolvedScene } from './resolve-scene.ts';
import type { Feature } from './scene-needs.ts';
import type { Material } from './schema.ts';

export function pathNeeds(scene: ResolvedScene): { readonly features: readonly Feature[]; readonly emitters: number } {
  const { camera, materials, objects, around } = scene;
  const emitters = sceneEmitters(scene);
  const materialOf = ({ material }: ResolvedObject): Material => materials[material] as Material;
  const transmissive = objects.filter((object) => materialOf(object).transmission > 0);
  const solid = transmissive.filter(({ shape }) => primitiveOf(shape).closed);
  const emissive = materials.filter(isEmissive);
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
    lens: !!camera.aperture && camera.type !== 'orthographic',
    orthographic: camera.type === 'orthographic',
  };
  return {
    features: [...(Object.keys(facts) as Feature[]).filter((feature) => facts[feature]), ...emitterFeatures(emitters)],
    emitters: emitters.length,
  };
}

/** Whether a material reflects or refracts at its surface, besides what it scatters below. */
const hasFacets = ({ metalness, specular, transmission }: Material): boolean =>
  metalness > 0 || specular > 0 || transmission > 0;
