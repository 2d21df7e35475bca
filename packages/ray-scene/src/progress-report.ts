import type { Scene } from '@ray-scene/core';
import { RaySceneCompleteEvent, RaySceneLoadEvent, RaySceneProgressEvent } from './events.ts';
import { Milestone } from './milestone.ts';
import type { Progress } from './picture.ts';

/** Tells how far the picture is, by events and by promises. */
export class ProgressReport {
  readonly ready = new Milestone();
  readonly complete = new Milestone();
  readonly #host: EventTarget;
  #loads = true;
  /** Whether there is more to tell, though it be less than a sample of each pixel, before the picture is complete. */
  #grows = false;

  constructor(host: EventTarget) {
    this.#host = host;
  }

  /** The next picture is of another scene, not of an edited one. */
  expectLoad(): void {
    this.#loads = true;
  }

  /** @param current the scene as it is now, or undefined if the picture is still of an earlier one. */
  tell({ samples, added, more, stopped, error }: Progress, total: number, current: Scene | undefined): void {
    if (current) {
      this.ready.resolve();
      if (this.#loads) this.#host.dispatchEvent(new RaySceneLoadEvent(current));
      this.#loads = false;
    }
    if (added) this.#host.dispatchEvent(new RaySceneProgressEvent('progress', samples, total));
    this.#grows ||= added || more;
    if (more || !stopped) {
      this.complete.renew();
      return;
    }
    if (current) this.complete.resolve();
    if (this.#grows) this.#host.dispatchEvent(new RaySceneCompleteEvent(samples, total, stopped, error));
    this.#grows = false;
  }

  fail(error: Error): void {
    this.#loads = true;
    this.ready.reject(error);
    this.complete.reject(error);
  }
}
