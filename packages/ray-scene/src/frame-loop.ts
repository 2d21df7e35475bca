import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';

/** Of the time between two frames no more counts: the page was hidden meanwhile, or at a standstill. */
const LONGEST_FRAME = 0.1;

/** One turn of the loop. */
export interface Frame {
  /** Whether anybody can see the element. */
  readonly visible: boolean;
  /** Seconds since the frame before, or 0 after a rest. */
  readonly seconds: number;
  /** How many elements of the page want this frame, this one included: they share its time. */
  readonly sharers: number;
}

/** Calls back once per frame while frames are wanted and the element is in sight; idle otherwise. */
export class FrameLoop implements ReactiveController {
  static readonly #wanting = new Set<FrameLoop>();

  readonly #host: ReactiveControllerHost & Element;
  readonly #callback: (frame: Frame) => boolean;
  #observer: IntersectionObserver | undefined;
  #request = 0;
  #inSight = false;
  #before = 0;

  /** @param callback does the work of a frame, and tells whether it wants another as long as the element is in sight. */
  constructor(host: ReactiveControllerHost & Element, callback: (frame: Frame) => boolean) {
    this.#host = host;
    this.#callback = callback;
    host.addController(this);
  }

  hostConnected(): void {
    this.#observer = new IntersectionObserver((entries) => {
      this.#inSight = entries.at(-1)?.isIntersecting ?? false;
      this.request();
    });
    this.#observer.observe(this.#host);
    document.addEventListener('visibilitychange', this.request);
    this.request();
  }

  hostDisconnected(): void {
    this.#observer?.disconnect();
    document.removeEventListener('visibilitychange', this.request);
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#inSight = false;
    this.#rest();
  }

  /** Asks for a frame, in sight or not: something has changed. */
  readonly request = (): void => {
    if (this.#host.isConnected) this.#request ||= requestAnimationFrame(this.#run);
  };

  readonly #run = (now: number): void => {
    this.#request = 0;
    FrameLoop.#wanting.add(this);
    const visible = this.#inSight && !document.hidden;
    const seconds = this.#before && Math.min(LONGEST_FRAME, (now - this.#before) / 1000);
    const more = this.#callback({ visible, seconds, sharers: FrameLoop.#wanting.size });
    if (more && visible) {
      this.#before = now;
      this.request();
    } else this.#rest();
  };

  #rest(): void {
    this.#before = 0;
    FrameLoop.#wanting.delete(this);
  }
}
