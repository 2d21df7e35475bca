/** From the neutral description of a scene to ours: the other renderer's conventions end here. */
import type { Vec3 } from '@ray-scene/core';
import type { NeutralCamera, NeutralEnvironment, NeutralLight, NeutralScene } from './neutral-scene.ts';
import { ENVIRONMENT_ROTATION } from './translate-environment.ts';
import { materialOf } from './translate-material.ts';
import { shapeOf, turned } from './translate-shape.ts';
import { given, Untranslatable } from './untranslatable.ts';

/** A scene of ours and how it is rendered, or why there is none. */
export type TranslatedScene =
  | { readonly scene: object; readonly bounces: number; readonly skipped?: undefined }
  | { readonly skipped: string };

/** Paths of any length are cut here: no scene of ours has more bounces. */
const MOST_BOUNCES = 64;

export function translateScene(neutral: NeutralScene): TranslatedScene {
  try {
    return { scene: sceneOf(neutral), bounces: bouncesOf(neutral) };
  } catch (error) {
    if (error instanceof Untranslatable) return { skipped: error.message };
    throw error;
  }
}

function sceneOf(neutral: NeutralScene): object {
  const { camera, environment, lights } = neutral;
  return {
    version: 1,
    camera: cameraOf(camera),
    ...environmentOf(environment),
    lights: lights.map(lightOf),
    objects: neutral.objects.map((object) => turned({ ...shapeOf(object), ...materialOf(object, neutral) }, object)),
  };
}

/** Theirs counts the segments of a path, ours what lies between two of them. */
function bouncesOf({ integrator }: NeutralScene): number {
  if (integrator.type === 'direct') return 1;
  if (integrator.type !== 'path') throw new Untranslatable(`there is no integrator ${integrator.type}`);
  const depth = given(integrator, 'mitsubaMaxDepth').mitsubaMaxDepth;
  return depth < 0 ? MOST_BOUNCES : Math.min(depth - 1, MOST_BOUNCES);
}

const cameras: { readonly [type: string]: (camera: NeutralCamera) => object } = {
  perspective: (camera) => ({ fov: given(camera, 'vfovDegrees').vfovDegrees }),
  orthographic: (camera) => ({ type: 'orthographic', height: given(camera, 'viewHeight').viewHeight }),
  thinLens: (camera) => {
    const { vfovDegrees, apertureRadius, focusDistance } = given(
      camera,
      'vfovDegrees',
      'apertureRadius',
      'focusDistance',
    );
    return { fov: vfovDegrees, aperture: apertureRadius, focusDistance };
  },
};

function cameraOf(camera: NeutralCamera): object {
  const translate = Object.hasOwn(cameras, camera.type) ? cameras[camera.type] : undefined;
  if (!translate) throw new Untranslatable(`there is no camera ${camera.type}`);
  return { position: camera.origin, target: camera.target, up: camera.up, ...translate(camera) };
}

const lights: { readonly [type: string]: (light: NeutralLight) => object } = {
  point: (light) => ({ ...given(light, 'position'), color: given(light, 'intensity').intensity }),
  directional: (light) => ({ ...given(light, 'direction'), color: given(light, 'irradiance').irradiance }),
  spot: (light) => {
    const { cutoffDegrees: angle, intensity } = given(light, 'cutoffDegrees', 'intensity');
    const { beamWidthDegrees = 0.75 * angle } = light;
    return { ...given(light, 'position', 'target'), color: intensity, angle, penumbra: 1 - beamWidthDegrees / angle };
  },
};

function lightOf(light: NeutralLight): object {
  const translate = Object.hasOwn(lights, light.type) ? lights[light.type] : undefined;
  if (!translate) throw new Untranslatable(`there is no light ${light.type}`);
  return { type: light.type, ...translate(light) };
}

function environmentOf(environment: NeutralEnvironment | null): object {
  if (!environment) return { background: [0, 0, 0] satisfies Vec3 };
  if (environment.type === 'envmap') {
    const { file: src } = given(environment, 'file', 'width', 'height');
    return { environment: { src, rotation: ENVIRONMENT_ROTATION }, background: 'environment' };
  }
  if (environment.type !== 'constant') throw new Untranslatable(`environments of the type ${environment.type}`);
  return { environment: { color: given(environment, 'radiance').radiance }, background: 'environment' };
}
