import type { ReactiveController } from '@lit/reactive-element';
import type { ResolvedCamera } from '@ray-scene/core';
import type { CameraControls } from './camera-controls.ts';
import { type CanvasHost, canvasOf } from './canvas-size.ts';

export interface OrbitHost extends CanvasHost {
  readonly cameraControls: boolean;
  readonly autoRotate: boolean;
  /** The camera of the picture, as soon as there is one. */
  readonly camera: ResolvedCamera | undefined;
}

/**
 * Lets people look around: a camera of their own stands in for the scene's, which is never written to. How they move it is
 * loaded when an element first asks for it.
 */
export class Orbit implements ReactiveController {
  readonly #host: OrbitHost;
  readonly #changed: () => void;
  #controls: CameraControls | undefined;
  #loading = false;
  #override: ResolvedCamera | undefined;

  constructor(host: OrbitHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
    host.addController(this);
  }

  /** The camera that stands in for the scene's. */
  get override(): ResolvedCamera | undefined {
    return this.#override;
  }

  /** Goes to this camera, or back to that of the scene. */
  reset(camera?: ResolvedCamera): void {
    this.#controls?.reset();
    this.#set(camera);
  }

  /** Goes on with `auto-rotate`; returns whether it turns. */
  turn(seconds: number): boolean {
    return this.#host.autoRotate && !!this.#controls?.turn(seconds);
  }

  hostConnected(): void {
    this.#controls?.hold();
  }

  hostUpdated(): void {
    const canvas = canvasOf(this.#host);
    if (!canvas || this.#loading || !(this.#host.cameraControls || this.#host.autoRotate)) return;
    this.#loading = true;
    import('./camera-controls.ts').then(({ CameraControls }) => {
      this.#controls = new CameraControls(this.#host, canvas, (camera) => this.#set(camera), this.#changed);
      this.#changed();
    }, reportError);
  }

  hostDisconnected(): void {
    this.#controls?.release();
  }

  #set(camera: ResolvedCamera | undefined): void {
    this.#override = camera;
    this.#changed();
  }
}
