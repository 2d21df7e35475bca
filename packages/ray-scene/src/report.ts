import type { ReactiveControllerHost } from '@lit/reactive-element';
import { type Problem, SceneError } from '@ray-scene/core';
import { RaySceneErrorEvent } from './events.ts';

/** Tells what is wrong: in the element for who looks at it, on the console for who wrote it, as an event for scripts. */
export class ErrorReport {
  readonly #host: ReactiveControllerHost & EventTarget;
  #error: Error | undefined;

  constructor(host: ReactiveControllerHost & EventTarget) {
    this.#host = host;
  }

  /** All that is wrong now, or undefined. What was told before and has not changed is not told again. */
  tell(error: Error | undefined): void {
    if (error?.message === this.#error?.message) return;
    const known = lines(this.#error);
    this.#error = error;
    this.#host.requestUpdate();
    if (!error) return;
    for (const line of lines(error)) if (!known.includes(line)) console.error(line);
    this.#host.dispatchEvent(new RaySceneErrorEvent(error));
  }

  /** What is wrong, in words. */
  get text(): string | undefined {
    return this.#error?.message;
  }
}

const lines = (error: Error | undefined): string[] =>
  error instanceof SceneError ? error.problems.map(lineOf) : error ? [error.message] : [];

const lineOf = ({ where, message }: Problem): string => `${where}: ${message}`;
