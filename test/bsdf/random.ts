/** Random numbers for tests: seeded, and exact in f32. */
import { hash } from '../../packages/core/src/random.ts';

/** A source of numbers in [0, 1). */
export function numbers(seed: number): () => number {
  let count = 0;
  return () => (hash(hash(seed) ^ count++) >>> 8) * 2 ** -24;
}
