// Ray against box along the axes: the common part of three slabs, by true division. Source: T. Kay and J. Kajiya, "Ray
// Tracing Complex Scenes", SIGGRAPH 1986. The corners are relative to the ray's start, for the camera from f64.
// Precision: f32. The divisions cost no more than reciprocals of d and the products with them, which lose the last digit.
#include "shape/convex.glsl"
#include "split-dot.glsl"

// What all rays from a point share: the ways to the lowest and the highest corner.
struct BoxFrom {
  vec3 low;
  vec3 high;
};

BoxFrom boxFrom(Box s, vec3 o) {
#ifdef WIDE_RANGE
  return BoxFrom((s.low - o) + s.low2, (s.high - o) + s.high2);
#else
  return BoxFrom(s.low - o, s.high - o);
#endif
}

BoxFrom boxFromCamera(Box s) {
  return BoxFrom(s.low, s.high);
}

// Along a slab (d = 0) the quotients are endless, of the same sign outside and of opposite ones inside. A face counts as
// inside: SMALLEST makes an endless one of 0 / 0. It must not be there for other rays: one that starts on a face would meet
// that face again.
float boxDistance(Box s, BoxFrom from, vec3 d, float own) {
  vec3 along = SMALLEST * vec3(equal(d, vec3(0.0)));
  vec3 a = (from.low - along) / d;
  vec3 b = (from.high + along) / d;
  vec3 entries = min(a, b);
  vec3 exits = max(a, b);
  float entry = max(max(entries.x, entries.y), entries.z);
  float exit = min(min(exits.x, exits.y), exits.z);
  return convexDistance(vec2(entry, exit), own);
}

#ifdef SHADOWS
// Above 0 where it is in the way within the limit.
float boxOcclusion(Box s, BoxFrom from, vec3 d, float limit, float own) {
  return limit - boxDistance(s, from, d, own);
}
#endif

// 1 for the axis of the face that a point is on: the one that it is outside of most, or least inside.
vec3 boxAxis(BoxFrom at) {
  vec3 outside = max(at.low, -at.high);
  if (outside.x >= max(outside.y, outside.z)) return vec3(1.0, 0.0, 0.0);
  return outside.y >= outside.z ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
}

// The unit normal on the side that d comes from, times a weight.
vec3 boxNormal(Box s, BoxFrom at, vec3 d, float weight) {
  vec3 axis = boxAxis(at);
  return (dotInOrder(axis, d) > 0.0 ? -weight : weight) * axis;
}

#ifdef SIDES
// Whether the ray comes from outside. At a low face the way to the high one is the longer.
bool boxFront(Box s, BoxFrom at, vec3 d) {
  vec3 axis = boxAxis(at);
  return (dotInOrder(axis, d) > 0.0) == (dotInOrder(axis, at.low + at.high) > 0.0);
}
#endif

#ifdef BOX_CHECKER
// The surface lengths (U, V) from the lowest corner, counted in cells: (z, y) on the x faces, (x, z) on y, (x, y) on z.
vec2 boxCells(Box s, vec3 p) {
  BoxFrom at = boxFrom(s, p);
  vec3 q = -at.low * s.perCell;
  vec3 axis = boxAxis(at);
  return axis.x > 0.5 ? q.zy : (axis.y > 0.5 ? q.xz : q.xy);
}
#endif
