import { builtInMaterials } from './built-in-materials.ts';
import type { ShaderOptions } from './generate-shader.ts';
import { loadedParts, loadedPaths } from './parts.ts';
import type { Camera, Material, Scene } from './schema.ts';
import type { RenderSettings } from './settings.ts';

/** Scenes of so many spheres and planes, and of so many lights, one after the other, never make up one of many. */
const FEW = 4;

type PartialScene = { readonly [K in 'objects' | 'lights']: Scene[K] } & Partial<Pick<Scene, 'materials' | 'camera'>>;

/**
 * Loads what a scene needs beyond a few spheres and planes on a GPU, lit by points; undefined: it is all there. A scene
 * with other shapes, or one that is gone through path by path, can be resolved, packed and traced only after that.
 */
export function loadParts(
  scene: PartialScene,
  { varyings = 0 }: ShaderOptions = {},
  { integrator }: Partial<Pick<RenderSettings, 'integrator'>> = {},
): Promise<unknown> | undefined {
  const { objects, lights } = scene;
  const paths = integrator === 'path' || mayFollowPaths(scene);
  const isSimple = varyings === 0 && objects.every(({ type }) => type === 'sphere' || type === 'plane');
  const more = paths || !isSimple || objects.length > FEW || lights.length > FEW;
  const wanted = [
    ...(more && !loadedParts() ? [import('./more-parts.ts')] : []),
    ...(paths && !loadedPaths() ? [import('./path-parts.ts')] : []),
  ];
  return wanted.length > 0 ? Promise.all(wanted) : undefined;
}

/** Whether even `direct` may have to go path by path: see `followsPaths`, which knows for sure. */
function mayFollowPaths({ objects, lights, materials = {}, camera }: PartialScene): boolean {
  return (
    isMoreThanPinhole(camera) ||
    lights.some((light) =>
      light.type === 'directional' ? light.angularDiameter > 0 : light.type === 'spot' || light.radius > 0,
    ) ||
    objects.some((object) => {
      const named =
        object.material === undefined ? {} : (materials[object.material] ?? builtInMaterials[object.material] ?? {});
      return shinesOrTransmits(object) || shinesOrTransmits(named);
    })
  );
}

const isMoreThanPinhole = (camera: Camera | undefined): boolean =>
  camera?.type === 'orthographic' || (camera?.aperture ?? 0) > 0;

const shinesOrTransmits = ({ emission, transmission }: Partial<Material>): boolean =>
  !!transmission || !!emission?.some((channel) => channel > 0);
