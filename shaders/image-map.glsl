// Images on surfaces. A point is brought to the unit form of its kind of shape, where its place (u, v) on the image is told:
// u from the left, v from the bottom, from 0 to 1, as docs/scene.md has it. Texel centres are at (i + 1/2) / N; colours are
// linear between them. The filter is written out, since drivers differ in theirs. Precision: f32; a place is right to 4e-7 of
// the image where the camera is near.
#include "constants.glsl"
#include "split-dot.glsl"
#if defined(SPHERE_MAP) || defined(CYLINDER_MAP) || defined(CONE_MAP) || defined(TORUS_MAP)
#include "arc-tangent.glsl"
#endif

// All images, one after the other.
uniform highp sampler2D imageTexels;

struct ImagePlace {
  vec2 uv;
  // Whether the image goes on at its other edge.
  bvec2 around;
};

// A point of the scene in the unit form of the shape that has the material.
vec3 unitPoint(Material m, vec3 p) {
  return vec3(
    dotInOrder(m.mapX.xyz, p) + m.mapX.w,
    dotInOrder(m.mapY.xyz, p) + m.mapY.w,
    dotInOrder(m.mapZ.xyz, p) + m.mapZ.w
  );
}

#if defined(SPHERE_MAP) || defined(CYLINDER_MAP) || defined(CONE_MAP) || defined(TORUS_MAP)
// The angle of a point as a part of a full turn, from 0 to 1.
float turnOf(float y, float x) {
  return fract(0.159154943 * arcTangent(y, x));
}
#endif
#ifdef SPHERE_MAP
// From +z towards +x, and from -y to +y.
ImagePlace spherePlace(vec3 q) {
  float v = 1.0 - 0.318309886 * arcTangent(sqrt(q.x * q.x + q.z * q.z), q.y);
  return ImagePlace(vec2(turnOf(q.x, q.z), v), bvec2(true, false));
}
#endif
#ifdef PLANE_MAP
ImagePlace planePlace(vec3 q) {
  return ImagePlace(fract(q.xy), bvec2(true));
}
#endif
#ifdef DISC_MAP
// The square around the disc.
ImagePlace discPlace(vec3 q) {
  return ImagePlace(0.5 * q.xy + 0.5, bvec2(false));
}
#endif
#ifdef QUAD_MAP
ImagePlace quadPlace(vec3 q) {
  return ImagePlace(q.xy, bvec2(false));
}
#endif
#ifdef TRIANGLE_MAP
ImagePlace trianglePlace(vec3 q) {
  return ImagePlace(q.xy, bvec2(false));
}
#endif
#ifdef BOX_MAP
// On each face the whole image: (z, y), (x, z) or (x, y).
ImagePlace boxPlace(vec3 q) {
  vec3 outwards = abs(q - 0.5);
  vec2 uv = q.xy;
  if (outwards.x >= max(outwards.y, outwards.z)) uv = q.zy;
  else if (outwards.y >= outwards.z) uv = q.xz;
  return ImagePlace(uv, bvec2(false));
}
#endif
#ifdef CYLINDER_MAP
// Around the side, or on a cap the square around it.
ImagePlace cylinderPlace(vec3 q) {
  if (abs(2.0 * q.z - 1.0) > sqrt(q.x * q.x + q.y * q.y)) return ImagePlace(0.5 * q.xy + 0.5, bvec2(false));
  return ImagePlace(vec2(turnOf(q.y, q.x), q.z), bvec2(true, false));
}
#endif
#ifdef CONE_MAP
// Around the side, or on the base the square around it: on that, less is missing to height 0 than to the side.
ImagePlace conePlace(vec3 q) {
  float beside = sqrt(q.x * q.x + q.y * q.y) + q.z - 1.0;
  if (-q.z > beside) return ImagePlace(0.5 * q.xy + 0.5, bvec2(false));
  return ImagePlace(vec2(turnOf(q.y, q.x), q.z), bvec2(true, false));
}
#endif
#ifdef TORUS_MAP
// Around the axis, and around the tube from its outermost circle.
ImagePlace torusPlace(vec3 q) {
  float beside = sqrt(q.x * q.x + q.y * q.y) - 1.0;
  return ImagePlace(vec2(turnOf(q.y, q.x), turnOf(q.z, beside)), bvec2(true));
}
#endif

// The texel in column i and row j from the top.
vec3 imageTexel(vec3 image, int i, int j) {
  int n = int(image.x) + j * int(image.y) + i;
  return texelFetch(imageTexels, ivec2(n & 2047, n >> 11), 0).rgb;
}

// A number of a row or column within 0 to size - 1.
int withinImage(int i, int size, bool around) {
  if (around) return i < 0 ? i + size : (i < size ? i : i - size);
  return clamp(i, 0, size - 1);
}

// Multiplies the colour by that of the image.
void mapImage(inout Material m, ImagePlace place) {
  // There may be none on this object.
  if (m.image.y < 1.0) return;
  vec2 size = m.image.yz;
  vec2 at = clamp(vec2(place.uv.x, 1.0 - place.uv.y), 0.0, 1.0) * size - 0.5;
  vec2 low = floor(at);
  vec2 part = at - low;
  ivec2 first = ivec2(low);
  ivec2 x = ivec2(
    withinImage(first.x, int(size.x), place.around.x),
    withinImage(first.x + 1, int(size.x), place.around.x)
  );
  ivec2 y = ivec2(
    withinImage(first.y, int(size.y), place.around.y),
    withinImage(first.y + 1, int(size.y), place.around.y)
  );
  vec3 above = mix(imageTexel(m.image, x.x, y.x), imageTexel(m.image, x.y, y.x), part.x);
  vec3 below = mix(imageTexel(m.image, x.x, y.y), imageTexel(m.image, x.y, y.y), part.x);
  m.color *= mix(above, below, part.y);
}
