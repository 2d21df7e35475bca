// A cylinder: from outside, points of what is seen of it, all equally likely; from inside, all directions are. Precision: f32.
#include "arc-tangent.glsl"
#include "circle.glsl"
#include "tangents.glsl"
#include "light/emitter/area.glsl"
#ifdef INNER_EMITTER
#include "light/emitter/inside.glsl"
#endif

// A cylinder as it is seen from a point.
struct CylinderSeen {
  // Of the point above the base, along the axis.
  float height;
  // From the axis to the point, at right angles.
  vec3 outwards;
  float away;
  // How far around from there the side is seen, to both sides, in radians; 0: not at all.
  float around;
  float sideArea;
  // Of a cap, if one is seen.
  float capArea;
};

// c: the way to the base.
CylinderSeen cylinderSeen(Emitter e, vec3 c) {
  float height = -dotInOrder(e.axis, c);
  vec3 outwards = cross(cross(c, e.axis), e.axis);
  float away = sqrt(dotInOrder(outwards, outwards));
  float power = (away - e.radius) * (away + e.radius);
  float around = power > 0.0 ? arcTangent(sqrt(power), e.radius) : 0.0;
  float capArea = height < 0.0 || height > e.height ? 3.14159265359 * e.radius * e.radius : 0.0;
  return CylinderSeen(height, outwards, away, around, 2.0 * around * e.radius * e.height, capArea);
}

EmitterSample cylinderCap(Emitter e, vec3 c, CylinderSeen seen, vec2 u) {
  vec3 x;
  vec3 y;
  tangents(e.axis, x, y);
  vec2 place = e.radius * sqrt(u.x) * circle(u.y);
  bool below = seen.height < 0.0;
  vec3 middle = below ? c : c + e.height * e.axis;
  float above = below ? -seen.height : seen.height - e.height;
  return areaSample(e, middle + (place.x * x + place.y * y), above, seen.sideArea + seen.capArea, true);
}

EmitterSample cylinderSide(Emitter e, vec3 c, CylinderSeen seen, vec2 u) {
  float turn = 2.0 * u.x - 1.0;
  vec2 turned = circle(abs(turn) * seen.around * 0.159154943);
  vec3 toPoint = seen.outwards / seen.away;
  vec3 normal = turned.x * toPoint + (turn < 0.0 ? -turned.y : turned.y) * cross(e.axis, toPoint);
  vec3 way = c + (u.y * e.height) * e.axis + e.radius * normal;
  // Above the tangent plane: away cos - radius, which cancels near the outline, as away times a difference of cosines.
  float halfTurn = 0.0795774715 * seen.around;
  float above = 2.0 * seen.away * circle(halfTurn * (1.0 - abs(turn))).y * circle(halfTurn * (1.0 + abs(turn))).y;
  return areaSample(e, way, above, seen.sideArea + seen.capArea, true);
}

#ifdef INNER_EMITTER
// How far the surface is from a point inside; 0 for directions out of the part of it that the point is on.
float cylinderExit(Emitter e, CylinderSeen seen, vec3 d, bool own) {
  float up = dotInOrder(e.axis, d);
  vec3 across = d - up * e.axis;
  float outward = dotInOrder(seen.outwards, d);
  vec3 depth = abs(vec3(e.radius - seen.away, seen.height, e.height - seen.height));
  float leaving = depth.x <= depth.y && depth.x <= depth.z ? outward : depth.y <= depth.z ? -up : up;
  if (own && leaving > 0.0) return 0.0;
  float a = dotInOrder(across, across);
  float power = (seen.away - e.radius) * (seen.away + e.radius);
  float root = sqrt(max(outward * outward - a * power, 0.0));
  float side = outward < 0.0 ? (root - outward) / max(a, SMALLEST) : -power / max(outward + root, SMALLEST);
  float cap = up > 0.0 ? (e.height - seen.height) / up : -seen.height / up;
  return min(a > 0.0 ? side : MISS, up == 0.0 ? MISS : cap);
}
#endif

EmitterSample cylinderSample(Emitter e, vec3 p, vec2 u, bool own) {
  vec3 c = wayTo(e, p);
  CylinderSeen seen = cylinderSeen(e, c);
  float area = seen.sideArea + seen.capArea;
  if (own || !(area > 0.0)) {
#ifdef INNER_EMITTER
    vec3 around = aroundDirection(u);
    return insideSample(e, around, cylinderExit(e, seen, around, own), AROUND_PDF);
#else
    return NO_LIGHT;
#endif
  }
  float place = u.x * area;
  if (place < seen.capArea) return cylinderCap(e, c, seen, vec2(place / seen.capArea, u.y));
  return cylinderSide(e, c, seen, vec2((place - seen.capArea) / max(seen.sideArea, SMALLEST), u.y));
}

float cylinderPdf(Emitter e, vec3 from, vec3 d, float t, float cosine, bool own) {
  CylinderSeen seen = cylinderSeen(e, wayTo(e, from));
  float area = seen.sideArea + seen.capArea;
#ifdef INNER_EMITTER
  if (own || !(area > 0.0)) return insidePdf(e);
#else
  if (own) return 0.0;
#endif
  return areaPdf(t, cosine, area);
}
