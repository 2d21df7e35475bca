// The quartic s⁴ + 2 h s² + 4 j s + … of a ray and a torus: where it is stationary, between which of these places the root
// is that the ray meets first, and that root, from the stationary point next to it. Derivation and source: `torus.glsl`.
// Precision: f32. The values at the stationary points are worked out there, without cancellation.

float torusCubicStep(float s, float h, float j) {
  return s - (s * (s * s + h) - j) / max(3.0 * s * s + h, SMALLEST);
}

// The cube root, too large by up to 8 %: the bits of a number, read as an integer, grow as its logarithm does.
float cubeRoughly(float x) {
  return intBitsToFloat(int(float(floatBitsToInt(x)) * 0.333333333) + 710500000);
}

// Where the quartic is stationary, in order.
vec3 torusStationary(float h, float j) {
  // The largest root for -|j|, which is not below 0. It is looked for from within a factor of 2.
  float size = abs(j);
  float root = cubeRoughly(size);
  float square = root * root;
  float largest = mix(size / (h + square), sqrt(max(square - h, 0.0)), h < 0.0);
  largest = torusCubicStep(largest, h, size);
  largest = torusCubicStep(largest, h, size);
  largest = torusCubicStep(largest, h, size);
  float apart = sqrt(max(-3.0 * largest * largest - 4.0 * h, 0.0));
  float least = 0.5 * (largest + apart);
  float middle = mix(0.5 * largest, size / (largest * least), apart > 0.0);
  return mix(vec3(-least, -middle, largest), vec3(-largest, middle, least), bvec3(j > 0.0));
}

// Where to look for a root: from the stationary point `center`, forwards or backwards (`towards`, 1 or -1), where the
// quartic has risen (`rising` 1) or fallen (-1) by `level`. It is not farther than `bound`.
struct TorusSearch {
  bool hits;
  float center;
  float towards;
  float rising;
  float level;
  float bound;
  // The root is in between, and behind it the power has this sign.
  float after;
  float before;
  float sense;
};

// `values` are those of the quartic at its stationary points. From outside (or inside) the root is where the ray gets into
// a valley (or out of it), the first one after the start. A ray that leaves the torus itself has its own root on the slope
// on which it starts: it is that slope's end which tells whether it is one before, since the start is nearer to it only by
// rounding.
TorusSearch torusSearch(vec3 stationary, vec3 values, float start, bool inside, bool leaves) {
  bool beforePeak = start < stationary.y;
  bool beforeSecond = start < stationary.z;
  bool beforeFirst = start < stationary.x;
  if (leaves) {
    beforePeak = start < 0.5 * (stationary.x + stationary.y);
    beforeSecond = start < 0.5 * (stationary.y + stationary.z);
    beforeFirst = false;
  }
  bool atFirst = inside ? beforePeak && values.y >= 0.0 : beforeFirst && values.x < 0.0;
  bool hits = inside || atFirst || (beforeSecond && values.z < 0.0);
  float valley = mix(stationary.z, stationary.x, atFirst);
  float depth = -mix(values.z, values.x, atFirst);
  // Between valley and peak, from whichever is nearer in value.
  bool inner = atFirst == inside;
  bool down = inner && values.y < depth;
  float level = max(mix(depth, values.y, down), 0.0);
  return TorusSearch(
    hits,
    mix(valley, stationary.y, down),
    inside == down ? -1.0 : 1.0,
    down ? -1.0 : 1.0,
    level,
    mix(sqrt(sqrt(level)), 0.6 * abs(stationary.y - valley), inner),
    inside ? valley : (atFirst ? -MISS : stationary.y),
    inside ? (atFirst ? stationary.y : MISS) : valley,
    inside ? 1.0 : -1.0
  );
}

// What the quartic rises or falls by, from a stationary point on: v linear + v² ((v + shift)² + bend) times `rising`.
struct TorusRise {
  float linear;
  float shift;
  float bend;
  float rising;
};

float torusRiseStep(TorusRise rise, float level, float v) {
  float y = v + rise.shift;
  float square = rise.rising * (y * y + rise.bend);
  float slope = rise.linear + 2.0 * v * (square + v * rise.rising * y);
  // Roots are within 1 of the centre.
  return clamp(v - (v * (rise.linear + v * square) - level) / max(slope, SMALLEST), 0.0, 2.0);
}

float torusRoot(TorusSearch search, float h, float j) {
  float center = search.center;
  float curved = center * center + h;
  float linear = max(4.0 * search.rising * search.towards * (center * curved + j), 0.0);
  float shift = 2.0 * search.towards * center;
  TorusRise rise = TorusRise(linear, shift, 2.0 * curved, search.rising);
  float square = max(search.rising * (shift * shift + 2.0 * curved), SMALLEST);
  float cube = max(search.rising * 2.0 * shift, SMALLEST);
  float v = min(search.bound, search.level / max(linear, SMALLEST));
  v = min(v, min(sqrt(search.level / square), cubeRoughly(search.level / cube)));
  v = torusRiseStep(rise, search.level, v);
  v = torusRiseStep(rise, search.level, v);
  v = torusRiseStep(rise, search.level, v);
  return center + search.towards * v;
}
