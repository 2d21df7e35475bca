/** How long the GPU takes, learnt without waiting for it. */

interface Batch {
  readonly owner: object;
  readonly fence: WebGLSync | null;
  readonly start: number;
  readonly done: (milliseconds: number) => void;
}

/**
 * Work is issued in batches that the GPU finishes in order. A fence at the end of each is asked from timers: WebGL
 * answers between tasks only.
 */
export class GpuClock {
  readonly #gl: WebGL2RenderingContext;
  #unfinished: Batch[] = [];
  #lastFinish = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  /** Whose work the GPU is at, as far as is known. */
  get busyWith(): object | undefined {
    return this.#unfinished[0]?.owner;
  }

  /** Ends a batch of which the first call was issued at `start` (performance.now()). */
  endBatch(owner: object, start: number, done: Batch['done']): void {
    const fence = this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.#gl.flush();
    this.#unfinished.push({ owner, fence, start, done });
    this.#timer ??= setTimeout(this.#poll);
  }

  /** Forgets all batches, as when the context is lost. */
  reset(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    for (const { fence } of this.#unfinished) this.#gl.deleteSync(fence);
    this.#unfinished = [];
  }

  readonly #poll = (): void => {
    this.#timer = undefined;
    // Whoever was at work is asked for when the event of the loss arrives.
    if (this.#gl.isContextLost()) return;
    const now = performance.now();
    const running = this.#unfinished.findIndex(({ fence }) => !this.#isDone(fence));
    const finished = this.#unfinished.splice(0, running < 0 ? this.#unfinished.length : running);
    const [first] = finished;
    if (first) {
      // Batches that are seen to end together share the time between them.
      const each = (now - Math.max(first.start, this.#lastFinish)) / finished.length;
      this.#lastFinish = now;
      for (const { fence, done } of finished) {
        this.#gl.deleteSync(fence);
        done(each);
      }
    }
    if (this.#unfinished.length > 0) this.#timer ??= setTimeout(this.#poll);
  };

  #isDone(fence: WebGLSync | null): boolean {
    return !fence || this.#gl.getSyncParameter(fence, this.#gl.SYNC_STATUS) === this.#gl.SIGNALED;
  }
}
