// A box: from outside, points of the faces that are seen, all equally likely; from inside, all directions are. Precision: f32.
#include "light/emitter/area.glsl"
#ifdef INNER_EMITTER
#include "light/emitter/inside.glsl"
#endif

// The area of the face across x that is seen from a point, and of those across y and z; c: the way to the middle.
vec3 boxSeen(Emitter e, vec3 c) {
  vec3 h = e.edgeU;
  return mix(vec3(0.0), 4.0 * vec3(h.y * h.z, h.z * h.x, h.x * h.y), greaterThan(abs(c), h));
}

#ifdef INNER_EMITTER
// How far the surface is from a point inside; 0 for directions out of the face that the point is on.
float boxExit(Emitter e, vec3 c, vec3 d, bool own) {
  vec3 forward = mix(vec3(1.0), vec3(-1.0), lessThan(d, vec3(0.0)));
  vec3 ends = mix((c + forward * e.edgeU) / d, vec3(MISS), equal(d, vec3(0.0)));
  vec3 depth = abs(abs(c) - e.edgeU);
  vec3 leaving = c * d;
  bool leaves = (depth.x <= depth.y && depth.x <= depth.z ? leaving.x : depth.y <= depth.z ? leaving.y : leaving.z) < 0.0;
  return own && leaves ? 0.0 : min(min(ends.x, ends.y), ends.z);
}
#endif

EmitterSample boxSample(Emitter e, vec3 p, vec2 u, bool own) {
  vec3 c = wayTo(e, p);
  vec3 areas = boxSeen(e, c);
  float area = areas.x + areas.y + areas.z;
  if (own || !(area > 0.0)) {
#ifdef INNER_EMITTER
    vec3 around = aroundDirection(u);
    return insideSample(e, around, boxExit(e, c, around, own), AROUND_PDF);
#else
    return NO_LIGHT;
#endif
  }
  float place = u.x * area;
  vec3 height = abs(c) - e.edgeU;
  vec3 face = mix(height, -height, lessThan(c, vec3(0.0)));
  float v = 2.0 * u.y - 1.0;
  if (place < areas.x) {
    float w = 2.0 * (place / areas.x) - 1.0;
    return areaSample(e, vec3(face.x, c.y + e.edgeU.y * w, c.z + e.edgeU.z * v), height.x, area, true);
  }
  place -= areas.x;
  if (place < areas.y) {
    float w = 2.0 * (place / areas.y) - 1.0;
    return areaSample(e, vec3(c.x + e.edgeU.x * v, face.y, c.z + e.edgeU.z * w), height.y, area, true);
  }
  float w = 2.0 * ((place - areas.y) / max(areas.z, SMALLEST)) - 1.0;
  return areaSample(e, vec3(c.x + e.edgeU.x * w, c.y + e.edgeU.y * v, face.z), height.z, area, true);
}

float boxPdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  vec3 areas = boxSeen(e, wayTo(e, from));
  float area = areas.x + areas.y + areas.z;
#ifdef INNER_EMITTER
  if (own || !(area > 0.0)) return insidePdf(e);
#else
  if (own) return 0.0;
#endif
  return areaPdf(t, cosine, area);
}
