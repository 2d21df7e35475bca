/**
 * Pointer events on an object of a scene made of child elements happen to its element, in place of the picture, and bubble
 * from there. A chunk that is loaded with the first of them.
 */
import { type PickHost, pick } from './pick.ts';

export interface ObjectEventsHost extends PickHost, Element {
  readonly cameraControls: boolean;
}

const TYPES = [
  'pointerover',
  'pointerout',
  'pointerdown',
  'pointermove',
  'pointerup',
  'pointercancel',
  'click',
  'auxclick',
  'dblclick',
  'contextmenu',
];

/** How far a pointer may go between down and up, in CSS pixels, for a click that did not look around. */
const CLICK_SLACK = 5;

interface Press {
  readonly element: Element | undefined;
  readonly x: number;
  readonly y: number;
}

export class ObjectEvents {
  readonly #host: ObjectEventsHost;
  readonly #canvas: HTMLCanvasElement;
  /** By pointer, the element of the object that it is over. */
  readonly #over = new Map<number, Element | undefined>();
  #press: Press | undefined;

  constructor(host: ObjectEventsHost, canvas: HTMLCanvasElement) {
    this.#host = host;
    this.#canvas = canvas;
    for (const type of TYPES) canvas.addEventListener(type, this);
  }

  /** Also takes events that were held back until now. */
  handleEvent(event: Event): void {
    // The other types are mouse events too: `click` is not yet a pointer event everywhere.
    const target = this.#targetOf(event as PointerEvent);
    const isOver = event.eventPhase === Event.NONE;
    if (!target && !isOver) return;
    event.stopPropagation();
    const copy = copyOf(event as PointerEvent, {});
    if (!(target ?? this.#host).dispatchEvent(copy)) event.preventDefault();
    if (event.type === 'pointerover') this.#tell('pointerenter', target, event as PointerEvent);
    if (event.type === 'pointerout') this.#tell('pointerleave', target, event as PointerEvent);
  }

  /** The element that an event is for, if it is not for the whole picture. */
  #targetOf(event: PointerEvent): Element | undefined {
    const { type, pointerId, clientX: x, clientY: y } = event;
    const before = this.#over.get(pointerId);
    if (type === 'pointerout') {
      this.#over.delete(pointerId);
      return before;
    }
    const element = pick(this.#host, this.#canvas.getBoundingClientRect(), x, y)?.element;
    if (type === 'click') return this.#isClick(element, x, y) ? element : undefined;
    if (!type.startsWith('pointer')) return element;
    this.#over.set(pointerId, element);
    if (type !== 'pointerover' && element !== before) this.#cross(before, element, event);
    if (type === 'pointerdown') this.#press = { element, x, y };
    return element;
  }

  /** As everywhere, whoever clicks goes down and up on the same element; and a drag that looks around is no click. */
  #isClick(element: Element | undefined, x: number, y: number): boolean {
    const press = this.#press;
    if (!press) return true;
    return (
      element === press.element && !(this.#host.cameraControls && Math.hypot(x - press.x, y - press.y) > CLICK_SLACK)
    );
  }

  /** A pointer has gone from one object, or from none, to another. */
  #cross(before: Element | undefined, element: Element | undefined, event: PointerEvent): void {
    const from = before ?? this.#host;
    const to = element ?? this.#host;
    from.dispatchEvent(copyOf(event, { type: 'pointerout', relatedTarget: to }));
    this.#tell('pointerleave', before, event, to);
    to.dispatchEvent(copyOf(event, { type: 'pointerover', relatedTarget: from }));
    this.#tell('pointerenter', element, event, from);
  }

  #tell(type: string, element: Element | undefined, event: PointerEvent, other = event.relatedTarget): void {
    element?.dispatchEvent(copyOf(event, { type, bubbles: false, cancelable: false, relatedTarget: other }));
  }
}

/** An event that says the same, but for what is said otherwise. */
function copyOf(event: PointerEvent, { type = event.type, ...other }: PointerEventInit & { type?: string }): Event {
  const Kind = event.constructor as typeof PointerEvent;
  // An event is read as the init of another; a spread would not see its getters, which stand in its prototype.
  const get = (_: PointerEvent, name: string): unknown => Reflect.get(name in other ? other : event, name);
  return new Kind(type, new Proxy(event, { get }));
}
