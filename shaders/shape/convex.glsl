// What convex solids share: a line is inside of one from t.x to t.y, or never where t.x > t.y. Precision: f32.

// The nearest way in or out that is ahead, or MISS. Of a ray that leaves the solid's own surface (own = 1), the crossing
// nearer to 0 is the one where it starts: whatever was rounded, it is left out. What is not below MISS is a miss.
float convexDistance(vec2 t, float own) {
  float nearest = mix(t.y, t.x, min(t.x, 0.5 - own) > 0.0);
  float least = mix(0.0, -t.x, own > 0.5);
  return mix(MISS, nearest, t.x <= t.y && nearest > least);
}

// The part of the line for which t rate <= height.
vec2 belowPlane(float rate, float height) {
  float t = height / rate;
  if (rate == 0.0) return height < 0.0 ? vec2(MISS, -MISS) : vec2(-MISS, MISS);
  return rate > 0.0 ? vec2(-MISS, t) : vec2(t, MISS);
}

#ifdef WIDE_RANGE
// How far a line runs to where it is nearest to a small solid, v being the way there: from that point on, all that is
// compared is as small as the solid. 0 where the ray starts near it anyway.
float approach(vec3 v, vec3 d, float size) {
  return dot(v, v) > 64.0 * size * size ? dot(v, d) / dot(d, d) : 0.0;
}
#endif

vec2 bothOf(vec2 a, vec2 b) {
  return vec2(max(a.x, b.x), min(a.y, b.y));
}
