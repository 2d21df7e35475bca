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
 * Where in its pixel the n-th sample lies: [0, 1)², x to the right, y down. Odd and even samples form two
 * independently scrambled sequences, so that the difference of their means tells the error of both.
 */
export function pixelSample(index: number, seed: number): readonly [number, number] {
  const i = index >>> 1;
  const scramble = hash(seed ^ hash(index & 1));
  return [unit(owen(reverseBits(i), hash(scramble))), unit(owen(sobolSecond(i), hash(scramble ^ 1)))];
}

/** The upper 24 bits as a fraction: exact in f32. */
const unit = (bits: number): number => (bits >>> 8) * 2 ** -24;

/** Second dimension of the Sobol sequence: its direction numbers are the rows of Pascal's triangle modulo 2. */
function sobolSecond(index: number): number {
  let point = 0;
  let direction = 0x80000000;
  for (let i = index; i !== 0; i >>>= 1) {
    if (i & 1) point ^= direction;
    direction ^= direction >>> 1;
  }
  return point >>> 0;
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

function reverseBits(value: number): number {
  let x = (value >>> 16) | (value << 16);
  x = ((x & 0x00ff00ff) << 8) | ((x & 0xff00ff00) >>> 8);
  x = ((x & 0x0f0f0f0f) << 4) | ((x & 0xf0f0f0f0) >>> 4);
  x = ((x & 0x33333333) << 2) | ((x & 0xcccccccc) >>> 2);
  x = ((x & 0x55555555) << 1) | ((x & 0xaaaaaaaa) >>> 1);
  return x >>> 0;
}
