/** A promise of something that happens again and again. */
export class Milestone {
  #state: 'pending' | 'resolved' | 'rejected' = 'rejected';
  #promise!: Promise<void>;
  #resolve!: () => void;
  #reject!: (reason: Error) => void;

  constructor() {
    this.renew();
  }

  get promise(): Promise<void> {
    return this.#promise;
  }

  /** It has to happen anew. Who waits already goes on waiting. */
  renew(): void {
    if (this.#state === 'pending') return;
    this.#state = 'pending';
    this.#promise = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    // The page may have no interest in it: a failure that nobody waits for is told by the error event.
    this.#promise.catch(() => {});
  }

  resolve(): void {
    if (this.#state === 'rejected') this.renew();
    this.#state = 'resolved';
    this.#resolve();
  }

  reject(reason: Error): void {
    if (this.#state === 'resolved') this.renew();
    this.#state = 'rejected';
    this.#reject(reason);
  }
}
