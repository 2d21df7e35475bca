/** How fast samples come, and so how many pixels fit into a time. */

/** The first pixels, of which nobody knows how long they take: few enough even where a processor draws them. */
const FIRST_PIXELS = 2 ** 15;

/** By how much slower samples may seem to come at once. */
const SLOWER = 1.5;
/** How much of what is faster is believed: nearly none, since a frame that is too long is seen and one with room is not. */
const FASTER = 1 / 8;
/** So much faster is no luck: what was measured before held something else. */
const OTHER = 1 / 4;

export class Pace {
  #msPerPixel = 0;

  get isKnown(): boolean {
    return this.#msPerPixel > 0;
  }

  /** Milliseconds for so many pixels; 0: not known yet. */
  msFor(pixels: number): number {
    return this.#msPerPixel * pixels;
  }

  /** How many pixels are done in that time, as far as is known. */
  pixelsIn(ms: number): number {
    return this.isKnown ? ms / this.#msPerPixel : FIRST_PIXELS;
  }

  /**
   * Takes a measurement. It may hold the time that a driver took for the program, or that nobody looked: so one that is
   * much faster is believed at once, a slower one by half, and not how much slower it seems.
   */
  learn(ms: number, pixels: number): void {
    const measured = ms / pixels;
    const before = this.#msPerPixel || measured;
    this.#msPerPixel =
      measured < OTHER * before
        ? measured
        : Math.min(before + (measured < before ? FASTER : 0.5) * (measured - before), SLOWER * before);
  }
}
