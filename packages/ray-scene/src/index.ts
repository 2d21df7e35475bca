/** `ray-scene`: registers `<ray-scene>` and the elements of a scene. */
import { RayScene, sceneElements } from './element.ts';

export * from './element.ts';

// The parts first, so that a scene that is in the page already finds its parts to be what they are. On a server there
// is nothing to register with.
for (const [tag, element] of Object.entries({ ...sceneElements, 'ray-scene': RayScene })) {
  if (globalThis.customElements && !customElements.get(tag)) customElements.define(tag, element);
}
