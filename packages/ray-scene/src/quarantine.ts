/**
 * Keeps a scene that the GPU gave up on twice from being drawn, for the sake of the others on the page. Loaded when it gave
 * up once.
 */

/** Two losses within this time of each other, both during its work, and a scene is not tried a third time. */
const SUSPICION_MS = 60_000;

export class QuarantineError extends Error {
  override readonly name = 'QuarantineError';

  constructor() {
    super(
      'Twice the graphics card gave up while it drew this scene, so it is not tried again. ' +
        'A smaller picture, fewer objects or fewer bounces may do.',
    );
  }
}

export class Quarantine {
  #lastLoss = Number.NEGATIVE_INFINITY;
  /** The key of a scene that must not be drawn any more. */
  #key: string | undefined;

  /** The GPU gave up, then, while it drew the scene of this key. Returns whether that was once too often. */
  suspect(key: string, now: number): boolean {
    const again = now - this.#lastLoss < SUSPICION_MS;
    this.#lastLoss = now;
    if (again) this.#key = key;
    return again;
  }

  /** Whether anything is locked up. */
  get isOn(): boolean {
    return this.#key !== undefined;
  }

  /** Whether the scene of this key may be drawn. One other than that which is locked up starts with a clean slate. */
  lets(key: string): boolean {
    if (this.#key === key) return false;
    this.#key = undefined;
    this.#lastLoss = Number.NEGATIVE_INFINITY;
    return true;
  }
}
