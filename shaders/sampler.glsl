// Random numbers as integer hashes and Owen-scrambled Sobol points, the same bits as random.ts in every engine.
// Source: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; the hash is PCG (M. Jarzynski and M. Olano,
// JCGT 9(3), 2020). Precision: exact; the points are the upper 24 bits, which f32 holds.

struct Sampler {
  uint seed;
  // Number of the sample within its half-sequence, its bits reversed.
  uint reversed;
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

// Owen scrambling of a number: bits depend only on higher bits, which are the lower ones where it is reversed, as it is
// here and as it is returned.
uint owenReversed(uint reversed, uint seed) {
  uint x = reversed + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  return x ^ (x * 0x8d22f6e6u);
}

// The point of the second dimension of the Sobol sequence, its bits reversed; see random.ts.
uint sobolSecondReversed(uint index) {
  uint x = index;
  x ^= x >> 16;
  x ^= (x & 0xff00ff00u) >> 8;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xccccccccu) >> 2;
  return x ^ ((x & 0xaaaaaaaau) >> 1);
}

uint turned(uint bits, int by) {
  return (bits >> by) | (bits << (32 - by));
}

float unit(uint bits) {
  return float(bits >> 8) * (1.0 / 16777216.0);
}

// Of this fragment's pixel: `seed` and `reversed` are those of the sequence and its sample.
Sampler pixelSampler(uint seed, uint reversed) {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  return Sampler(hash(pixel.x ^ hash(pixel.y ^ seed)), reversed);
}

// A point of [0, 1)² of the `set`-th of the padded sequences.
vec2 sample2d(Sampler s, uint set) {
  uint scramble = hash(s.seed + set * 0x9e3779b9u);
  // The first dimension of the Sobol sequence is the index, reversed.
  uint i = reverseBits(owenReversed(s.reversed, scramble));
  uint first = owenReversed(i, turned(scramble, 11));
  uint second = owenReversed(sobolSecondReversed(i), turned(scramble, 22));
  return vec2(unit(reverseBits(first)), unit(reverseBits(second)));
}
