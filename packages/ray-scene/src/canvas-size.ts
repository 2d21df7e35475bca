import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';

/** Who renders a canvas, from its first update on. */
export interface CanvasHost extends ReactiveControllerHost {
  readonly renderRoot: ParentNode | undefined;
}

export const canvasOf = ({ renderRoot }: CanvasHost): HTMLCanvasElement | null | undefined =>
  renderRoot?.querySelector('canvas');

/** Follows how many device pixels the canvas covers. */
export class CanvasSize implements ReactiveController {
  readonly #host: CanvasHost;
  readonly #changed: () => void;
  #observer: ResizeObserver | undefined;
  #screen: MediaQueryList | undefined;
  #entry: ResizeObserverEntry | undefined;

  constructor(host: CanvasHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
    host.addController(this);
  }

  /** Width and height in pixels; 0 before there is a layout. `ratio`: pixels per CSS pixel; default: the screen's. */
  measure(ratio?: number): readonly [number, number] {
    if (!this.#entry) return [0, 0];
    const { contentRect, devicePixelContentBoxSize } = this.#entry;
    // Only the browser knows how it rounded the edges to device pixels; WebKit does not tell.
    const exact = devicePixelContentBoxSize?.[0];
    if (exact && ratio === undefined) return [exact.inlineSize, exact.blockSize];
    const scale = ratio ?? devicePixelRatio;
    return [Math.round(contentRect.width * scale), Math.round(contentRect.height * scale)];
  }

  hostConnected(): void {
    this.#watchScreen();
    this.#observe();
  }

  hostUpdated(): void {
    this.#observe();
  }

  hostDisconnected(): void {
    this.#observer?.disconnect();
    this.#observer = undefined;
    this.#screen?.removeEventListener('change', this.#watchScreen);
  }

  #observe(): void {
    const canvas = canvasOf(this.#host);
    if (!canvas || this.#observer) return;
    this.#observer = new ResizeObserver((entries) => {
      this.#entry = entries.at(-1);
      this.#changed();
    });
    try {
      this.#observer.observe(canvas, { box: 'device-pixel-content-box' });
    } catch {
      this.#observer.observe(canvas);
    }
  }

  /** A query for the present ratio changes once, when it is no longer the ratio. */
  readonly #watchScreen = (): void => {
    this.#screen = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    this.#screen.addEventListener('change', this.#watchScreen, { once: true });
    this.#changed();
  };
}
