import { sceneElements } from './scene-elements.ts';

/** A rule selector for the children that are parts of the scene. */
const nodes = Object.keys(sceneElements)
  .map((tag) => `::slotted(${tag})`)
  .join();

/** Of what every element has. */
export const styles = `
  :host {
    display: block;
    position: relative;
    aspect-ratio: 3 / 2;
  }
  /* As wide as a picture is by default where nothing else says how wide it is, as in a row of a flexbox. */
  :host::before {
    content: '';
    display: grid;
    grid: auto / minmax(0, 300px);
  }
  :host([hidden]),
  [hidden] {
    display: none !important;
  }
  canvas,
  img,
  ::slotted([slot='poster']),
  .nodes,
  ::slotted(:focus-visible) {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    writing-mode: horizontal-tb;
  }
  canvas[tabindex] {
    cursor: grab;
    touch-action: pan-y;
  }
  canvas[tabindex]:active {
    cursor: grabbing;
  }
  img,
  ::slotted([slot='poster']) {
    object-fit: contain;
  }
  canvas:focus-visible,
  ::slotted(:focus-visible) {
    outline: var(--ray-scene-focus-ring, 2px solid Highlight);
    outline-offset: -2px;
  }
  /* Not display: none, with which the parts of the scene could not have the focus. */
  .nodes {
    visibility: hidden;
    overflow: hidden;
    pointer-events: none;
  }
  ${nodes} {
    visibility: visible;
  }
`;
