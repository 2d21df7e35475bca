import { orbitCamera, panCamera, type ResolvedCamera, zoomCamera } from '@ray-scene/core';
import type { OrbitHost } from './orbit.ts';
import { KEYS_ID } from './shadow-tree.ts';

/** One press of an arrow key, in radians and in heights of the picture. */
const KEY_TURN = Math.PI / 24;
const KEY_PAN = 1 / 20;
const KEY_ZOOM = 1.1;
/** A drag over the height of the picture, in radians. */
const DRAG_TURN = Math.PI;
/** Zoom per CSS pixel that the wheel scrolls. A line of wheels that count in lines is 16 of those. */
const WHEEL_ZOOM = 1 / 500;
const LINE_HEIGHT = 16;
/** How far controls may take the camera from the target, as factors on the distance where they started. */
const NEAREST = 1e-3;
const FARTHEST = 1e3;
/** Radians per second: once around in half a minute. */
const AUTO_ROTATION = Math.PI / 15;

const ARROWS: { readonly [key: string]: readonly [right: number, up: number] } = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const LISTENED = ['pointerdown', 'pointermove', 'pointerup', 'pointercancel', 'wheel', 'keydown'];

type Point = readonly [x: number, y: number];

const apart = (a: Point, b: Point): number => Math.max(1, Math.hypot(a[0] - b[0], a[1] - b[1]));

/** What pointers, wheel and keys do to the camera. */
export class CameraControls {
  readonly #host: OrbitHost;
  readonly #canvas: HTMLCanvasElement;
  readonly #set: (camera: ResolvedCamera | undefined) => void;
  readonly #pointers = new Map<number, Point>();
  readonly #changed: () => void;
  readonly #stillness = matchMedia('(prefers-reduced-motion: reduce)');
  #zoom = 1;

  /**
   * @param set puts a camera in place of the scene's, or gives that back.
   * @param changed told when the reader of the page wants no motion, or wants it again.
   */
  constructor(
    host: OrbitHost,
    canvas: HTMLCanvasElement,
    set: (camera: ResolvedCamera | undefined) => void,
    changed: () => void,
  ) {
    this.#host = host;
    this.#canvas = canvas;
    this.#set = set;
    for (const type of LISTENED) canvas.addEventListener(type, this);
    this.#changed = changed;
    // It may have left the page while this was loaded.
    if (canvas.isConnected) this.hold();
    canvas.after(keysText());
  }

  /** Goes on with `auto-rotate`, unless somebody holds the scene; returns whether the reader of the page wants motion. */
  turn(seconds: number): boolean {
    if (this.#stillness.matches) return false;
    if (this.#pointers.size === 0) this.#move((camera) => orbitCamera(camera, AUTO_ROTATION * seconds, 0));
    return true;
  }

  /** From here on the zoom counts anew. */
  reset(): void {
    this.#zoom = 1;
  }

  /** To be called when the element comes into a page again. */
  hold(): void {
    this.#stillness.addEventListener('change', this.#changed);
  }

  /** Lets go of all pointers, and of the page. */
  release(): void {
    this.#pointers.clear();
    this.#stillness.removeEventListener('change', this.#changed);
  }

  handleEvent(event: Event): void {
    if (!this.#host.cameraControls) return;
    if (event instanceof KeyboardEvent) this.#key(event);
    // A wheel event is a mouse event, and a pointer event as well.
    else if (event instanceof WheelEvent) this.#wheel(event, this.#canvas);
    else if (event.type === 'pointerdown') this.#press(event as PointerEvent, this.#canvas);
    else if (event.type === 'pointermove') this.#drag(event as PointerEvent, this.#canvas);
    else this.#pointers.delete((event as PointerEvent).pointerId);
  }

  #press(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (event.button !== 0 || this.#pointers.size === 2) return;
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
  }

  #drag(event: PointerEvent, { clientHeight }: HTMLCanvasElement): void {
    const before = this.#pointers.get(event.pointerId);
    if (!before) return;
    const here: Point = [event.clientX, event.clientY];
    this.#pointers.set(event.pointerId, here);
    const right = (here[0] - before[0]) / clientHeight;
    const down = (here[1] - before[1]) / clientHeight;
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    // Whoever drags holds the scene, not the camera. Of two fingers each moves their middle by half its way.
    if (other) {
      this.#zoomBy(apart(before, other) / apart(here, other));
      this.#move((camera) => panCamera(camera, -right / 2, down / 2));
    } else if (event.shiftKey) this.#move((camera) => panCamera(camera, -right, down));
    else this.#move((camera) => orbitCamera(camera, -right * DRAG_TURN, down * DRAG_TURN));
  }

  #wheel(event: WheelEvent, canvas: HTMLCanvasElement): void {
    const { activeElement } = canvas.getRootNode() as ShadowRoot;
    if (!event.ctrlKey && activeElement !== canvas) return;
    event.preventDefault();
    const unit = [1, LINE_HEIGHT, canvas.clientHeight][event.deltaMode] ?? 1;
    this.#zoomBy(Math.exp(event.deltaY * unit * WHEEL_ZOOM));
  }

  #key(event: KeyboardEvent): void {
    const { key, shiftKey } = event;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [right, up] = ARROWS[key] ?? [0, 0];
    if (ARROWS[key] && shiftKey) this.#move((camera) => panCamera(camera, right * KEY_PAN, up * KEY_PAN));
    else if (ARROWS[key]) this.#move((camera) => orbitCamera(camera, right * KEY_TURN, up * KEY_TURN));
    else if (key === '+' || key === '=') this.#zoomBy(1 / KEY_ZOOM);
    else if (key === '-' || key === '_') this.#zoomBy(KEY_ZOOM);
    else if (key === 'Home' || key === '0') this.#startOver();
    else return;
    event.preventDefault();
  }

  #startOver(): void {
    this.reset();
    this.#set(undefined);
  }

  #zoomBy(factor: number): void {
    const zoom = Math.min(FARTHEST, Math.max(NEAREST, this.#zoom * factor));
    this.#move((camera) => zoomCamera(camera, zoom / this.#zoom));
    this.#zoom = zoom;
  }

  #move(step: (camera: ResolvedCamera) => ResolvedCamera): void {
    const { camera } = this.#host;
    if (!camera) return;
    this.#set(step(camera));
  }
}

/** For who does not see the picture. */
function keysText(): HTMLElement {
  const text = document.createElement('span');
  text.id = KEYS_ID;
  text.hidden = true;
  text.textContent = 'Arrow keys look around, with shift they move; plus and minus zoom; 0 starts over.';
  return text;
}
