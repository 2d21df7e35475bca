/** Pictures of the f64 reference, as many at once as the machine has cores. */
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import type { ReferenceJob } from './reference-job.ts';

interface Order {
  readonly job: ReferenceJob;
  readonly resolve: (rgb: Float64Array) => void;
  readonly reject: (error: Error) => void;
}

export class ReferencePool {
  readonly #workers: Worker[] = [];
  #idle: Worker[] = [];
  readonly #waiting: Order[] = [];
  readonly #running = new Map<Worker, Order>();

  constructor(size = availableParallelism()) {
    for (let i = 0; i < size; i++) this.#start();
  }

  render(job: ReferenceJob): Promise<Float64Array> {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ job, resolve, reject });
      this.#next();
    });
  }

  async close(): Promise<void> {
    await Promise.all(this.#workers.map((worker) => worker.terminate()));
  }

  #start(): void {
    const worker = new Worker(new URL('./reference-worker.ts', import.meta.url));
    this.#workers.push(worker);
    this.#idle.push(worker);
    worker.on('message', (rgb: Float64Array) => this.#end(worker, ({ resolve }) => resolve(rgb)));
    // A worker that threw has ended, and the picture it was at is not to be had.
    worker.on('error', (error: Error) => {
      this.#running.get(worker)?.reject(error);
      this.#running.delete(worker);
      this.#start();
      this.#next();
    });
  }

  #end(worker: Worker, tell: (order: Order) => void): void {
    const order = this.#running.get(worker);
    this.#running.delete(worker);
    this.#idle.push(worker);
    if (order) tell(order);
    this.#next();
  }

  #next(): void {
    const worker = this.#idle.at(-1);
    const order = worker && this.#waiting.shift();
    if (!worker || !order) return;
    this.#idle = this.#idle.slice(0, -1);
    this.#running.set(worker, order);
    worker.postMessage(order.job);
  }
}
