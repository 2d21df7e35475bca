/** What is wrong, in words, over the picture. */
import { adoptStyles } from './adopt-styles.ts';

const style = `
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
`;

export class ErrorOverlay {
  readonly #root: ShadowRoot;
  readonly #element = document.createElement('div');

  constructor(root: ShadowRoot) {
    this.#root = root;
    this.#element.setAttribute('part', 'error');
    this.#element.setAttribute('role', 'alert');
    // A long text scrolls, so it can have the focus.
    this.#element.tabIndex = 0;
    root.append(this.#element);
  }

  /** Undefined: nothing is wrong any more. The same text again is not read out again. */
  show(text = ''): void {
    adoptStyles(this.#root, style);
    if (text === this.#element.textContent) return;
    this.#element.hidden = !text;
    this.#element.textContent = text;
  }
}
