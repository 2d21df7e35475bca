/** How long the GPU takes, learnt without waiting for it. */

interface Batch {
  readonly owner: object;
  /** Passed when the GPU begins with the batch, and when it is done. */
  readonly begin: WebGLSync | null;
  readonly end: WebGLSync | null;
  readonly time: (() => number | undefined) | undefined;
  readonly done: (milliseconds: number) => void;
}

/** Measures on the GPU itself, where the browser lets pages do that. */
export interface GpuTimer {
  begin(): void;
  /** Returns what gives the time in milliseconds, once the GPU is done; undefined where it cannot be known. */
  end(): () => number | undefined;
}

/**
 * Work is issued in batches that the GPU finishes in order. Fences around each are asked from timers: WebGL answers
 * between tasks only. What the GPU does between batches, as drawing the page, is not counted.
 */
export class GpuClock {
  /** Goes before fences. */
  timer: GpuTimer | undefined;
  readonly #gl: WebGL2RenderingContext;
  #unfinished: Batch[] = [];
  /** Of the batch that is being issued. */
  #begin: WebGLSync | null | undefined;
  #timing: GpuTimer | undefined;
  /** When the GPU had not begun yet with the first batch that is unfinished, as was last seen. */
  #idle = 0;
  #timeout: ReturnType<typeof setTimeout> | undefined;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  /** Whose work the GPU is at, as far as is known. */
  get busyWith(): object | undefined {
    return this.#unfinished[0]?.owner;
  }

  /** How many batches of an owner are not finished, as far as is known. */
  batchesOf(owner: object): number {
    return this.#unfinished.filter((batch) => batch.owner === owner).length;
  }

  /** To be called before the first call of a batch; further ones change nothing. */
  beginBatch(): void {
    if (this.#begin !== undefined) return;
    if (this.#unfinished.length === 0) this.#idle = performance.now();
    this.#begin = this.#fence();
    this.#timing = this.timer;
    this.#timing?.begin();
  }

  /** @param done is told how long the batch took. */
  endBatch(owner: object, done: Batch['done']): void {
    const time = this.#timing?.end();
    this.#unfinished.push({ owner, begin: this.#begin ?? null, end: this.#fence(), time, done });
    this.#begin = undefined;
    this.#gl.flush();
    this.#timeout ??= setTimeout(this.#poll);
  }

  /** Forgets all batches, as when the context is lost. */
  reset(): void {
    clearTimeout(this.#timeout);
    this.#timeout = this.timer = this.#begin = undefined;
    for (const { begin, end } of this.#unfinished) {
      this.#gl.deleteSync(begin);
      this.#gl.deleteSync(end);
    }
    this.#unfinished = [];
  }

  readonly #poll = (): void => {
    this.#timeout = undefined;
    // Whoever was at work is asked for when the event of the loss arrives.
    if (this.#gl.isContextLost()) return;
    const now = performance.now();
    const running = this.#unfinished.findIndex(({ end }) => !this.#isDone(end));
    const finished = this.#unfinished.splice(0, running < 0 ? this.#unfinished.length : running);
    // Batches that are seen to end together share the time between them.
    const each = (now - this.#idle) / finished.length;
    for (const { begin, end, time, done } of finished) {
      this.#gl.deleteSync(begin);
      this.#gl.deleteSync(end);
      done(time?.() ?? each);
    }
    const [next] = this.#unfinished;
    if (!next) return;
    if (finished.length > 0 || !this.#isDone(next.begin)) this.#idle = now;
    this.#timeout ??= setTimeout(this.#poll);
  };

  #fence(): WebGLSync | null {
    return this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  }

  #isDone(fence: WebGLSync | null): boolean {
    return !fence || this.#gl.getSyncParameter(fence, this.#gl.SYNC_STATUS) === this.#gl.SIGNALED;
  }
}
