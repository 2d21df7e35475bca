// The radiance of an image of the surroundings, in the orientation of three.js: the direction (x, y, z) is at
// u = atan(z, x) / 2 pi + 1/2 from the left and v = acos(y) / pi from the top, texel centres at halves. The filter is written
// out, since drivers differ in theirs. Precision: a place is right to 4e-7 of the image's width.
#include "arc-tangent.glsl"

// For each texel its colour, and how much likelier than the average it is that its square is chosen.
uniform highp sampler2D environmentTexels;

// Where a direction is in the image when that is turned about +y by `turn` of a full turn: texels from the left and the top.
vec2 placeInImage(float turn, vec3 d) {
  vec2 place = vec2(
    fract(0.159154943 * arcTangent(d.z, d.x) + 0.5 + turn),
    0.318309886 * arcTangent(sqrt(d.x * d.x + d.z * d.z), d.y)
  );
  return place * vec2(textureSize(environmentTexels, 0));
}

// The colour at a place: linear between the centres of texels.
vec3 environmentAt(vec2 place) {
  ivec2 size = textureSize(environmentTexels, 0);
  vec2 corner = floor(place - 0.5);
  vec2 part = place - 0.5 - corner;
  ivec2 low = ivec2(corner);
  // Round to the other side from left to right, but not over the poles.
  ivec2 x = ivec2(low.x < 0 ? low.x + size.x : low.x, low.x + 1 < size.x ? low.x + 1 : low.x + 1 - size.x);
  ivec2 y = clamp(ivec2(low.y, low.y + 1), 0, size.y - 1);
  vec3 above = mix(
    texelFetch(environmentTexels, ivec2(x.x, y.x), 0).rgb,
    texelFetch(environmentTexels, ivec2(x.y, y.x), 0).rgb,
    part.x
  );
  vec3 below = mix(
    texelFetch(environmentTexels, ivec2(x.x, y.y), 0).rgb,
    texelFetch(environmentTexels, ivec2(x.y, y.y), 0).rgb,
    part.x
  );
  return mix(above, below, part.y);
}

vec3 environmentImage(float turn, vec3 d) {
  return environmentAt(placeInImage(turn, d));
}
