/**
 * Choosing one of many with given probabilities in constant time.
 * Source: M. Vose, "A Linear Algorithm for Generating Random Numbers with a Given Distribution", IEEE TSE 17(9), 1991.
 */

/** One place for each of the many: a number falls into one of them, and takes it below its threshold, else its alias. */
export interface AliasTable {
  /** Rounded to f32, so that shader and reference choose alike. */
  readonly thresholds: Float64Array;
  readonly aliases: Float64Array;
  /** What comes of the rounded thresholds: of each, how likely it is to be chosen. */
  readonly probabilities: Float64Array;
}

/** A table that chooses in proportion to the weights. What has no weight is never chosen. */
export function aliasTable(weights: Float64Array): AliasTable {
  const count = weights.length;
  const largest = weights.reduce((best, weight, i) => (weight > (weights[best] as number) ? i : best), 0);
  // Over the largest first: the sum stays a number.
  const relative = weights.map((weight) => (weight > 0 ? weight / (weights[largest] as number) : 0));
  const total = relative.reduce((sum, weight) => sum + weight, 0);
  if (total === 0) return { thresholds: relative, aliases: relative, probabilities: relative };
  const left = relative.map((weight) => (weight * count) / total);
  const [small, large]: [number[], number[]] = [[], []];
  left.forEach((weight, i) => {
    (weight < 1 ? small : large).push(i);
  });
  const thresholds = new Float64Array(count).fill(1);
  const aliases = thresholds.map((_, i) => i);
  while (small.length > 0 && large.length > 0) {
    const [poor, rich] = [small.pop() as number, large.pop() as number];
    thresholds[poor] = Math.fround(left[poor] as number);
    aliases[poor] = rich;
    left[rich] = (left[rich] as number) - (1 - (left[poor] as number));
    ((left[rich] as number) < 1 ? small : large).push(rich);
  }
  // What rounding left over has about 1; without weight it is not to be chosen even so.
  for (const i of small) {
    if (relative[i] !== 0) continue;
    thresholds[i] = 0;
    aliases[i] = largest;
  }
  return { thresholds, aliases, probabilities: probabilitiesOf(thresholds, aliases) };
}

function probabilitiesOf(thresholds: Float64Array, aliases: Float64Array): Float64Array {
  const sums = thresholds.slice();
  aliases.forEach((alias, i) => {
    sums[alias] = (sums[alias] as number) + (1 - (thresholds[i] as number));
  });
  return sums.map((sum) => Math.fround(sum / thresholds.length));
}

/** So much less likely than the most powerful is the least powerful: random numbers in f32 still tell them apart. */
const LEAST_SHARE = 2 ** -12;

/** The table that emitters are chosen by. */
export function emitterTable(emitters: readonly { readonly power: number }[]): AliasTable {
  const most = Math.min(Math.max(0, ...emitters.map(({ power }) => power)), Number.MAX_VALUE);
  const least = LEAST_SHARE * most;
  const weightOf = (power: number): number => (power > 0 ? Math.min(Math.max(power, least), Number.MAX_VALUE) : 0);
  return aliasTable(Float64Array.from(emitters, ({ power }) => weightOf(power)));
}

/** Which one a random number from [0, 1) chooses. */
export function choose({ thresholds, aliases }: AliasTable, which: number): number {
  const place = Math.fround(Math.fround(which) * thresholds.length);
  const index = Math.min(Math.floor(place), thresholds.length - 1);
  return place - index < (thresholds[index] as number) ? index : (aliases[index] as number);
}
