import { type Problem, SceneError } from '@ray-scene/core';
import type { ErrorOverlay } from './error-overlay.ts';
import { RaySceneErrorEvent } from './events.ts';

/** Tells what is wrong: in the element for who looks at it, on the console for who wrote it, as an event for scripts. */
export class ErrorReport {
  readonly #host: HTMLElement;
  #error: Error | undefined;
  #overlay: Promise<ErrorOverlay> | undefined;

  constructor(host: HTMLElement) {
    this.#host = host;
  }

  /** All that is wrong now, or undefined. What was told before and has not changed is not told again. */
  tell(error: Error | undefined): void {
    if (error?.message === this.#error?.message) return;
    const known = lines(this.#error);
    this.#error = error;
    this.#show().catch(reportError);
    if (!error) return;
    for (const line of lines(error)) if (!known.includes(line)) console.error(line);
    this.#host.dispatchEvent(new RaySceneErrorEvent(error));
  }

  async #show(): Promise<void> {
    this.#overlay ??= import('./error-overlay.ts').then(
      ({ ErrorOverlay }) => new ErrorOverlay(this.#host.shadowRoot as ShadowRoot),
    );
    (await this.#overlay).show(this.#error?.message);
  }
}

const lines = (error: Error | undefined): string[] =>
  error instanceof SceneError ? error.problems.map(lineOf) : error ? [error.message] : [];

const lineOf = ({ where, message }: Problem): string => `${where}: ${message}`;
