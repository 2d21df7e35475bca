/** Pictures of the GPU as numbers. */
import '@ray-scene/core/parts';
import { type EnvironmentImages, parseSettings, type RenderSettings, type Scene } from '@ray-scene/core';
import { Renderer } from '../../packages/ray-scene/src/renderer.ts';

/** The mean of the samples of a scene: linear RGBA, the top row first. By `direct`, unless told otherwise. */
export function drawn(
  scene: Scene,
  { width, height, ...settings }: Partial<RenderSettings> & { readonly width: number; readonly height: number },
): Float32Array {
  const renderer = new Renderer(document.createElement('canvas'));
  renderer.onerror = (error) => {
    throw error;
  };
  renderer.setScene(scene);
  renderer.setSettings(parseSettings({ integrator: 'direct', ...settings }));
  renderer.resize(width, height);
  while (renderer.draw(1000));
  const radiance = renderer.readRadiance();
  renderer.dispose();
  return radiance;
}

/** The same where parts have to be loaded first, and with images that the scene names. */
export async function completePicture(
  scene: Scene,
  { width, height, ...settings }: Partial<RenderSettings> & { readonly width: number; readonly height: number },
  images: EnvironmentImages,
): Promise<Float32Array> {
  const renderer = new Renderer(document.createElement('canvas'));
  let restored = (): void => {};
  let failure: Error | undefined;
  renderer.onerror = (error) => {
    failure = error;
    restored();
  };
  renderer.onrestored = () => restored();
  renderer.setScene(scene, images);
  renderer.setSettings(parseSettings(settings));
  renderer.resize(width, height);
  for (;;) {
    const loaded = new Promise<void>((resolve) => {
      restored = resolve;
    });
    while (renderer.draw(1000));
    if (failure) throw failure;
    if (renderer.stopped) break;
    await loaded;
  }
  const radiance = renderer.readRadiance();
  renderer.dispose();
  return radiance;
}
