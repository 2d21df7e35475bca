import { loadWords, type Problem, SceneError } from '@ray-scene/core';
import type { ErrorOverlay } from './error-overlay.ts';
import { RaySceneErrorEvent } from './events.ts';

/** Tells what is wrong: in the element for who looks at it, on the console for who wrote it, as an event for scripts. */
export class ErrorReport {
  static #Overlay: typeof ErrorOverlay | undefined;
  static #loading: Promise<unknown> | undefined;
  static #isLoaded = false;
  readonly #host: HTMLElement;
  #error: Error | undefined;
  #overlay: ErrorOverlay | undefined;

  constructor(host: HTMLElement) {
    this.#host = host;
  }

  /** Loads what it takes to be sure that something is wrong, and to show it; undefined: it is all there, or not to be had. */
  load(): Promise<unknown> | undefined {
    if (ErrorReport.#isLoaded) return undefined;
    ErrorReport.#loading ??= Promise.all([
      loadWords(),
      import('./error-overlay.ts').then(({ ErrorOverlay }) => {
        ErrorReport.#Overlay = ErrorOverlay;
      }),
    ])
      .catch(reportError)
      .then(() => {
        ErrorReport.#isLoaded = true;
      });
    return ErrorReport.#loading;
  }

  /** All that is wrong now, or undefined. What was told before and has not changed is not told again. */
  tell(error: Error | undefined): void {
    const { shadowRoot } = this.#host;
    if (error && ErrorReport.#Overlay && shadowRoot) this.#overlay ??= new ErrorReport.#Overlay(shadowRoot);
    this.#overlay?.show(error?.message);
    if (error?.message === this.#error?.message) return;
    const known = lines(this.#error);
    this.#error = error;
    if (!error) return;
    for (const line of lines(error)) if (!known.includes(line)) console.error(line);
    this.#host.dispatchEvent(new RaySceneErrorEvent(error));
  }
}

const lines = (error: Error | undefined): string[] =>
  error instanceof SceneError ? error.problems.map(lineOf) : error ? [error.message] : [];

const lineOf = ({ where, message }: Problem): string => `${where}: ${message}`;
