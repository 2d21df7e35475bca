// An image of the surroundings: texels in proportion to the light that comes from their squares, by alias tables of the rows
// and of the texels in each (M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th ed., section 12.5, with the
// tables of emitter-table.ts). Precision: f32; near the edge of a texel f32 may find the pdf of its neighbour.
#include "circle.glsl"
#include "light/environment-image.glsl"

// Rows of width + 1 pairs: threshold and alias of each texel within its row; in the last place those of the row.
uniform highp sampler2D environmentChoices;

const float TWO_PI_SQUARED = 19.7392088022;

// One of many by an alias table, whose entry `pair` is the one that u falls on, and what of u is left, from 0 to 1.
vec2 chosenTexel(float place, float index, vec2 pair) {
  float rest = place - index;
  return rest < pair.x
    ? vec2(index, rest / pair.x)
    : vec2(pair.y, pair.x < 1.0 ? (rest - pair.x) / (1.0 - pair.x) : rest);
}

// A row by way of u.y, a texel of it by way of u.x; what is left of both is the place in the texel's square.
EmitterSample imageSample(Emitter e, vec3 p, vec2 u, bool own) {
  ivec2 size = textureSize(environmentTexels, 0);
  vec2 all = vec2(size);
  vec2 place = u * all;
  vec2 index = min(floor(place), all - 1.0);
  vec2 row = chosenTexel(place.y, index.y, texelFetch(environmentChoices, ivec2(size.x, int(index.y)), 0).xy);
  ivec2 at = ivec2(index.x, row.x);
  vec2 column = chosenTexel(place.x, index.x, texelFetch(environmentChoices, at, 0).xy);
  vec2 where = vec2(column.x + column.y, row.x + row.y);
  vec2 down = circle(0.5 * where.y / all.y);
  if (!(down.y > 0.0)) return NO_LIGHT;
  vec2 around = circle(fract(where.x / all.x + 0.5 - e.turn));
  float density = texelFetch(environmentTexels, ivec2(column.x, row.x), 0).a;
  return EmitterSample(
    vec3(down.y * around.x, down.x, down.y * around.y),
    MISS,
    min(e.strength * environmentAt(where), vec3(LARGEST)),
    density / max(TWO_PI_SQUARED * down.y, SMALLEST),
    false,
    -1
  );
}

float imagePdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  ivec2 size = textureSize(environmentTexels, 0);
  ivec2 at = min(ivec2(placeInImage(e.turn, d)), size - 1);
  float sine = sqrt(d.x * d.x + d.z * d.z);
  return sine > 0.0 ? texelFetch(environmentTexels, at, 0).a / max(TWO_PI_SQUARED * sine, SMALLEST) : 0.0;
}

vec3 imageRadiance(Emitter e, vec3 d) {
  return min(e.strength * environmentImage(e.turn, d), vec3(LARGEST));
}
