/**
 * Random numbers as integer hashes and Owen-scrambled Sobol points: no state, the same bits in every engine.
 * Source: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
 */

/** A well-mixed 32-bit hash: PCG (M. Jarzynski and M. Olano, JCGT 9(3), 2020). */
export function hash(value: number): number {
  const state = (Math.imul(value, 747796405) + 2891336453) >>> 0;
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0;
  return ((word >>> 22) ^ word) >>> 0;
}

/**
 * Where in its pixel the n-th sample lies, if at the same place in all of them: [0, 1)², x to the right, y down. Odd and
 * even samples form two independently scrambled sequences, so that the difference of their means tells the error of both.
 */
export function pixelSample(index: number, seed: number): readonly [number, number] {
  const i = index >>> 1;
  const scramble = hash(seed ^ hash(index & 1));
  return [unit(owen(reverseBits(i), hash(scramble))), unit(owen(sobolSecond(i), hash(scramble ^ 1)))];
}

/** Where a pixel's random numbers come from: see docs/light-transport.md. */
export interface Sampler {
  readonly seed: number;
  /** Number of the sample within its half-sequence. */
  readonly index: number;
}

/** Of the `index`-th sample of the pixel in column x and row y, counted from the lower left corner. */
export function pixelSampler(x: number, y: number, index: number, seed: number): Sampler {
  return { seed: hash(x ^ hash(y ^ sequenceSeed(index, seed))), index: index >>> 1 };
}

/** Where in its pixel a sample lies that has a place of its own: [0, 1)², x to the right, y down. */
export const ownPlace = (sampler: Sampler): readonly [number, number] => sample2d(sampler, PLACE_SET);

/** The set before all others, as an unsigned number the last one. */
const PLACE_SET = -1;

/** What all pixels' sequences have in common: the seed, and which of the two sequences the sample is of. */
export const sequenceSeed = (index: number, seed: number): number => hash((seed ^ hash((index & 1) + 2)) >>> 0);

/**
 * A point of [0, 1)²: of the `set`-th of the padded sequences, which are shuffled independently. One hash serves the
 * shuffle and both dimensions: turned, its bits decide something else in each of them.
 */
export function sample2d({ seed, index }: Sampler, set: number): readonly [number, number] {
  const scramble = hash((seed + Math.imul(set, 0x9e3779b9)) >>> 0);
  const i = owen(index, scramble);
  return [unit(owen(reverseBits(i), turned(scramble, 11))), unit(owen(sobolSecond(i), turned(scramble, 22)))];
}

const turned = (bits: number, by: number): number => ((bits >>> by) | (bits << (32 - by))) >>> 0;

/** The upper 24 bits as a fraction: exact in f32. */
const unit = (bits: number): number => (bits >>> 8) * 2 ** -24;

/**
 * Second dimension of the Sobol sequence, whose direction numbers are the rows of Pascal's triangle modulo 2. By Lucas'
 * theorem bit m of the point is the sum of all bits j of the index whose number j holds the bits of m: five sums of halves.
 */
function sobolSecond(index: number): number {
  let x = reverseBits(index);
  x ^= x << 16;
  x ^= (x & 0x00ff00ff) << 8;
  x ^= (x & 0x0f0f0f0f) << 4;
  x ^= (x & 0x33333333) << 2;
  x ^= (x & 0x55555555) << 1;
  return x >>> 0;
}

/** Owen scrambling by a hash whose bits depend only on higher bits (Laine and Karras, with Burley's constants). */
function owen(point: number, seed: number): number {
  let x = (reverseBits(point) + seed) | 0;
  x ^= Math.imul(x, 0x6c50b47c);
  x ^= Math.imul(x, 0xb82f1e52);
  x ^= Math.imul(x, 0xc7afe638);
  x ^= Math.imul(x, 0x8d22f6e6);
  return reverseBits(x);
}

/** The 32 bits of a number the other way round. */
export function reverseBits(value: number): number {
  let x = (value >>> 16) | (value << 16);
  x = ((x & 0x00ff00ff) << 8) | ((x & 0xff00ff00) >>> 8);
  x = ((x & 0x0f0f0f0f) << 4) | ((x & 0xf0f0f0f0) >>> 4);
  x = ((x & 0x33333333) << 2) | ((x & 0xcccccccc) >>> 2);
  x = ((x & 0x55555555) << 1) | ((x & 0xaaaaaaaa) >>> 1);
  return x >>> 0;
}
