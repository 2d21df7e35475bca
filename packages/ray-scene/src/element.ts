/** `ray-scene/element`: the classes of all elements. Registers nothing. */
import type { RayScene } from './ray-scene.ts';
import type { SceneElementTagNameMap } from './scene-elements.ts';

export {
  RaySceneCompleteEvent,
  RaySceneErrorEvent,
  type RaySceneEventMap,
  RaySceneLoadEvent,
  RaySceneProgressEvent,
} from './events.ts';
export type { RaySceneIntrinsicElements } from './jsx.ts';
export type { Picked } from './pick.ts';
export { RayScene } from './ray-scene.ts';
export type { RenderStats, StopReason } from './renderer.ts';
export { SceneElement, type SceneElementTagNameMap, sceneElements } from './scene-elements.ts';

declare global {
  interface HTMLElementTagNameMap extends SceneElementTagNameMap {
    'ray-scene': RayScene;
  }
}
