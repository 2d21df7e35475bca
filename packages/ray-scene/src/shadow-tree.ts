/** What `<ray-scene>` is made of inside. So little changes there that templates would be most of the code. */

export interface ShadowState {
  /** What the picture shows, in words; empty: nothing that has to be told. */
  readonly label: string;
  /** Whether keys look around. */
  readonly keys: boolean;
  readonly hasWebGL: boolean;
  readonly hasPicture: boolean;
  /** Address of an image to show until there is a picture. */
  readonly poster: string | null;
}

/** Of the text that says which keys there are; see `camera-controls.ts`. */
export const KEYS_ID = 'keys';

export class ShadowTree {
  readonly canvas = make('canvas', { part: 'canvas' });
  readonly #image = make('img', { alt: '' });
  readonly #poster = make('div', { part: 'poster' });
  readonly #nodes = make('div', {});

  constructor(root: ShadowRoot) {
    const poster = make('slot', { name: 'poster' });
    poster.append(this.#image);
    this.#poster.append(poster);
    this.#nodes.append(make('slot', {}));
    root.append(this.canvas, this.#poster, this.#nodes);
  }

  show({ label, keys, hasWebGL, hasPicture, poster }: ShadowState): void {
    set(this.canvas, {
      role: label ? 'img' : 'none',
      'aria-label': label || null,
      'aria-describedby': keys ? KEYS_ID : null,
      tabindex: keys ? '0' : null,
    });
    this.canvas.hidden = !hasWebGL;
    this.#poster.hidden = hasPicture || !hasWebGL;
    set(this.#image, { src: poster });
    this.#image.hidden = !poster;
    // Without a picture, whatever else the author put there is shown in its place.
    this.#nodes.classList.toggle('nodes', hasWebGL);
  }
}

/** By name; null: none. */
interface Attributes {
  readonly [name: string]: string | null;
}

function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  set(element, attributes);
  return element;
}

function set(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    // An address that is set again is loaded again.
    if (element.getAttribute(name) === value) continue;
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
  }
}
