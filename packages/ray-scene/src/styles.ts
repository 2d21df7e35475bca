import { unsafeCSS } from '@lit/reactive-element';
import { sceneElements } from './scene-elements.ts';

/** A rule selector for the children that are parts of the scene. */
const nodes = Object.keys(sceneElements)
  .map((tag) => `::slotted(${tag})`)
  .join();

// Lit's `css` would make sure that all of this is ours, which it is.
export const styles = unsafeCSS(`
  :host {
    display: block;
    position: relative;
    aspect-ratio: 3 / 2;
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
  [part='error'] {
    position: absolute;
    inset: auto 0 0;
    box-sizing: border-box;
    max-height: 100%;
    padding: 0.75em 1em;
    overflow: auto;
    overflow-wrap: anywhere;
    white-space: pre-line;
    font: 0.875rem / 1.4 system-ui, sans-serif;
    color: var(--ray-scene-error-color, #fff);
    background: var(--ray-scene-error-background, #8b1a1a);
  }
`);
