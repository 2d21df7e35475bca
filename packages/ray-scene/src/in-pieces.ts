import type { RowByRow } from '@ray-scene/core';

/** Milliseconds at a time: a frame has room for that beside what else the page does. */
const PIECE_MS = 8;

/** Does long work on an image, and lets the page do other things meanwhile. */
export async function inPieces<T>(work: RowByRow<T>): Promise<T> {
  for (;;) {
    const end = performance.now() + PIECE_MS;
    do {
      const step = work.next();
      if (step.done) return step.value;
    } while (performance.now() < end);
    await nextTask();
  }
}

/** By a message, since timers of pages that nobody looks at go off once a second. */
const nextTask = (): Promise<void> =>
  new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(undefined);
  });
