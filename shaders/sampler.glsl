// Random numbers as integer hashes and Owen-scrambled Sobol points, the same bits as random.ts in every engine.
// Source: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; the hash is PCG (M. Jarzynski and M. Olano,
// JCGT 9(3), 2020). Precision: exact; the points are the upper 24 bits, which f32 holds.

struct Sampler {
  uint seed;
  uint index;
};

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

uint reverseBits(uint value) {
  uint x = (value >> 16) | (value << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// Owen scrambling of a number whose bits are reversed, which is how it returns.
uint owenReversed(uint reversed, uint seed) {
  uint x = reversed + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reverseBits(x);
}

// The point of the second dimension of the Sobol sequence from the reversed index; see random.ts.
uint sobolSecond(uint reversed) {
  uint x = reversed;
  x ^= x << 16;
  x ^= (x & 0x00ff00ffu) << 8;
  x ^= (x & 0x0f0f0f0fu) << 4;
  x ^= (x & 0x33333333u) << 2;
  x ^= (x & 0x55555555u) << 1;
  return x;
}

float unit(uint bits) {
  return float(bits >> 8) * (1.0 / 16777216.0);
}

// Of this fragment's pixel: `seed` and `index` are those of the sequence and its sample.
Sampler pixelSampler(uint seed, uint index) {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  return Sampler(hash(pixel.x ^ hash(pixel.y ^ seed)), index);
}

// A point of [0, 1)² of the `set`-th of the padded sequences.
vec2 sample2d(Sampler s, uint set) {
  uint scramble = hash(s.seed ^ hash(set));
  uint i = owenReversed(reverseBits(s.index), scramble);
  // The first dimension is the reversed index, which scrambling reverses again.
  uint first = owenReversed(i, hash(scramble ^ 1u));
  uint second = owenReversed(reverseBits(sobolSecond(reverseBits(i))), hash(scramble ^ 2u));
  return vec2(unit(first), unit(second));
}
