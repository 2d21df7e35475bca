// Ray against planes of which one or more are not level. See plane.glsl. Precision: f32, and with WIDE_RANGE, where the unit
// vector down and the plane's point come in parts (see split-parts.ts), almost twice that.

#ifdef WIDE_RANGE
#include "split-dot.glsl"
#endif

vec3 planeDown(Plane s) {
#ifdef WIDE_RANGE
  return s.down + (s.down2 + s.down3);
#else
  return s.down;
#endif
}

float planeDescent(Plane s, vec3 v) {
#ifdef WIDE_RANGE
  return splitDot(s.down, s.down2, s.down3, v);
#else
  return dot(s.down, v);
#endif
}

// From whichever is nearer: the plane's point, or the camera, as what the height changes by on the way from there. So what
// is rounded is as small as it can be.
PlaneFrom planeFrom(Plane s, vec3 o) {
  vec3 way = s.point - o;
#ifdef WIDE_RANGE
  way += s.pointLow;
#endif
  bool near = dot(o, o) < dot(way, way);
  return PlaneFrom(mix(planeDescent(s, way), s.height - planeDescent(s, o), near));
}

#ifndef THROUGH
// The distance to the plane, or MISS. A ray that leaves the plane itself (own = 1) never meets it again, even where rounding
// turns one that just grazes it.
float planeDistance(Plane s, PlaneFrom from, vec3 d, float own) {
  float approach = planeDescent(s, d);
  bool meets = min(approach, 0.5 - own) > 0.0;
  return mix(MISS, from.height / approach, meets);
}

// The unit normal times a weight.
vec3 planeNormal(Plane s, PlaneFrom from, vec3 d, float weight) {
  return -weight * planeDown(s);
}
#endif
