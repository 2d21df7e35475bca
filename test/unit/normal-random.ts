/** Numbers of the normal distribution with mean 0 and variance 1, from a seed (G. Box and M. Muller, 1958). */
import { hash } from '../../packages/core/src/random.ts';

export function normalRandom(seed: number): () => number {
  let state = hash(seed);
  const uniform = (): number => {
    state = hash(state + 1);
    return (state + 0.5) / 2 ** 32;
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}
