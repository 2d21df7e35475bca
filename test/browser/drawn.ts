/** Pictures of the GPU as numbers. */
import '@ray-scene/core/parts';
import { parseSettings, type RenderSettings, type Scene } from '@ray-scene/core';
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
