/**
 * Work on an image that pauses after each row, and what comes of it. Large images take longer than a page should stand
 * still: between rows something else can be done.
 */
export type RowByRow<T> = Generator<undefined, T>;

/** Does all of it at once. */
export function toEnd<T>(work: RowByRow<T>): T {
  let step = work.next();
  while (!step.done) step = work.next();
  return step.value;
}
