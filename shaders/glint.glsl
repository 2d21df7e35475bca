// Directions in which a ball with a narrow lobe shows a lamp without extent: found by chance from a dull surface, they are
// rare and bright. From a surface that sees such a glint a path is sent towards it on purpose, with a probability, and
// what is found is weighted by the pdf of the mixture of this and the BSDF: no bias, whatever the glint's place and width.
// In the way of: J. Hanika et al., "Manifold Next Event Estimation", EGSR 2015; T. Zeltner et al., "Specular Manifold
// Sampling for Rendering High-Frequency Caustics and Glints", SIGGRAPH 2020. Here the place is that where the angles of
// incidence of the surface and the lamp are equal (Alhazen's problem: one angle in the plane of both and the centre), and
// the half vector's slope is taken as linear in the direction around it. In units of the radius, with the distances x and l
// to the surface and the lamp, b = 1/x + 1/l and the cosine c of incidence, a step on the ball turns the half vector against
// the normal by 1 + c b/2 in that plane and by 1 + b/(2c) across it; the step is x/c and x times that of the direction.
// Directions are in the frame of the surface that they leave. Precision: f32. The lobes need not be right for the picture
// to be, only drawn from with the pdf that is told; no length is squared that may leave the range.
#include "circle.glsl"
#include "constants.glsl"
#include "tangents.glsl"

// Directions around an axis, whose slopes along two others are spread as those of GGX facets are.
struct GlintLobe {
  vec3 axis;
  vec3 along;
  vec3 across;
  // The slopes along them that stand for alpha.
  vec2 widths;
  // The probability with which it is drawn from.
  float share;
};

// What a path may look for where it is, and the probability with which it looks; else the BSDF is drawn from.
// Each has a name, since compilers keep arrays in memory: they had taken a quarter of the time of a sample.
struct Glints {
  GlintLobe first;
#ifdef SECOND_GLINT
  GlintLobe second;
#endif
#ifdef THIRD_GLINT
  GlintLobe third;
#endif
#ifdef FOURTH_GLINT
  GlintLobe fourth;
#endif
  float probability;
};

// What is looked for at most.
const float MOST_PROBABLE = 0.5;
// The radiance, over the irradiance of all lamps, at which a glint is looked for in half of the cases.
const float EVEN_RADIANCE = 0.064;
// The least angle, 2^-18 exactly: directions in f32 are 16 times as dense.
const float NARROWEST = 3.814697265625e-6;
// Of Newton's method: most of the way is within 1e-6 of the place after 3.
const int GLINT_STEPS = 4;

// Where on the ball, seen from its centre, and what it mirrors there.
struct Incidence {
  // To the surface over that from the centre to it, and to the lamp alike.
  vec2 distances;
  // Of the angles of incidence.
  vec2 cosines;
  vec2 sines;
};

// Angles are from the surface, as (cosine, sine). `inverse` has the inverse distances of the surface and the lamp from the
// centre, in radii.
Incidence incidenceAt(vec2 angle, vec2 lamp, vec2 inverse) {
  vec2 fromLamp = vec2(lamp.x * angle.x + lamp.y * angle.y, lamp.y * angle.x - lamp.x * angle.y);
  vec2 c = vec2(angle.x, fromLamp.x) - inverse;
  vec2 s = vec2(angle.y, fromLamp.y);
  vec2 distances = sqrt(c * c + s * s);
  distances = max(distances, SMALLEST);
  return Incidence(distances, c / distances, s / distances);
}

vec2 angleOf(float c, float s) {
  return vec2(c, s) / max(sqrt(c * c + s * s), SMALLEST);
}

// The lobe of a pair at a point. Its share is what would come from there to the eye, roughly, over the irradiance of all
// lamps on a surface that faces them: 0 where the ball does not mirror the lamp to the point.
GlintLobe glintLobe(Glint glint, vec3 p, mat3 frame, bool looks, Bsdf bsdf, vec3 wo) {
  GlintLobe lobe = GlintLobe(vec3(0.0, 0.0, 1.0), vec3(0.0), vec3(0.0), vec2(1.0), 0.0);
  if (!looks) return lobe;
  vec3 toPoint = toLocal(frame, p - glint.center);
  vec3 toLamp = toLocal(frame, glint.toLamp);
  float away = sqrt(squared(toPoint));
  if (!(glint.strength > 0.0 && glint.radius < away && glint.nearness < 1.0)) return lobe;
  vec2 inverse = vec2(glint.radius / away, glint.nearness);
  // The plane of the centre, the surface and the lamp.
  vec3 x = toPoint / away;
  vec3 turn = cross(x, toLamp);
  float sine = sqrt(squared(turn));
  vec3 y;
  tangents(x, lobe.across, y);
  // Where it is hardly bent, any plane will do.
  if (sine > NARROWEST) lobe.across = turn / sine;
  y = cross(lobe.across, x);
  vec2 lamp = vec2(dotInOrder(x, toLamp), sine);
  vec2 high = 1.0 - inverse;
  vec2 angle = angleOf(high.y + high.x * lamp.x, high.x * lamp.y);
  Incidence place = incidenceAt(angle, lamp, inverse);
  for (int i = 0; i < GLINT_STEPS; i++) {
    vec2 c = place.cosines;
    vec2 s = place.sines;
    vec2 slopes = c * inverse / place.distances;
    // The tangent of half of what the angles differ by, over what a step changes of that.
    float over = 2.0 * (s.x * c.y - c.x * s.y);
    float under = (2.0 + (slopes.x + slopes.y)) * (1.0 + (c.x * c.y + s.x * s.y));
    angle = angleOf(angle.x * under + angle.y * over, angle.y * under - angle.x * over);
    place = incidenceAt(angle, lamp, inverse);
  }
  float cosine = place.cosines.x;
  if (!(cosine > 0.0 && place.cosines.y > 0.0)) return lobe;
  vec2 near = inverse / place.distances;
  float bend = near.x + near.y;
  // From the surface to the place: of unit length, however near.
  vec2 a = vec2(-cosine * angle.x - place.sines.x * angle.y, place.sines.x * angle.x - cosine * angle.y);
  vec2 turns = vec2(2.0 + cosine * bend, 2.0 * cosine + bend);
  lobe.axis = a.x * x + a.y * y;
  lobe.along = a.x * y - a.y * x;
  lobe.widths = max(2.0 * glint.alpha * cosine * near.x / turns, vec2(NARROWEST));
  if (!(lobe.axis.z > 0.0)) return lobe;
  float pdf;
  float irradiance = glint.strength * cosine * (near.x / turns.x) * (near.x / turns.y);
  lobe.share = irradiance * sum(bsdfValue(bsdf, wo, lobe.axis, pdf)) / 3.0;
  return lobe;
}

// Per solid angle.
float glintPdf(GlintLobe lobe, vec3 d) {
  float c = dotInOrder(d, lobe.axis);
  vec2 slopes = vec2(dotInOrder(d, lobe.along), dotInOrder(d, lobe.across)) / lobe.widths;
  float square = c * c + (slopes.x * slopes.x + slopes.y * slopes.y);
  return max(c, 0.0) * INVERSE_PI / (lobe.widths.x * lobe.widths.y) / max(square * square, SMALLEST);
}

// A unit direction, with its pdf: that of the slopes, not of the direction, whose rounding makes much of a narrow lobe.
vec3 glintSample(GlintLobe lobe, vec2 u, out float pdf) {
  float rest = 1.0 - u.y;
  vec2 slopes = sqrt(u.y / rest) * circle(u.x) * lobe.widths;
  float size = sqrt(1.0 + (slopes.x * slopes.x + slopes.y * slopes.y));
  pdf = rest * rest * (size * size * size) * INVERSE_PI / (lobe.widths.x * lobe.widths.y);
  return (lobe.axis + slopes.x * lobe.along + slopes.y * lobe.across) / size;
}

// What there is to look for at a point on an object, more often the more it would bring; nothing unless light is asked for
// at the next surface.
Glints glintsAt(vec3 p, int object, bool asks, mat3 frame, Bsdf bsdf, vec3 wo) {
  Glints g;
  bool looks = asks && !isMirrorOnly(bsdf);
  g.first = glintLobe(glints[0], p, frame, looks && glints[0].object != object, bsdf, wo);
  float all = g.first.share;
#ifdef SECOND_GLINT
  g.second = glintLobe(glints[1], p, frame, looks && glints[1].object != object, bsdf, wo);
  all += g.second.share;
#endif
#ifdef THIRD_GLINT
  g.third = glintLobe(glints[2], p, frame, looks && glints[2].object != object, bsdf, wo);
  all += g.third.share;
#endif
#ifdef FOURTH_GLINT
  g.fourth = glintLobe(glints[3], p, frame, looks && glints[3].object != object, bsdf, wo);
  all += g.fourth.share;
#endif
  g.probability = min(all / (all + EVEN_RADIANCE), MOST_PROBABLE);
  float scale = g.probability / max(all, SMALLEST);
  g.first.share *= scale;
#ifdef SECOND_GLINT
  g.second.share *= scale;
#endif
#ifdef THIRD_GLINT
  g.third.share *= scale;
#endif
#ifdef FOURTH_GLINT
  g.fourth.share *= scale;
#endif
  return g;
}

// The pdf of a direction that the BSDF is drawn with `pdf`, by whatever way it was found; `known` is that of the lobe `which`.
float pdfWithGlints(Glints g, vec3 wi, float pdf, int which, float known) {
  float all = (1.0 - g.probability) * pdf;
  all += g.first.share * (which == 0 ? known : glintPdf(g.first, wi));
#ifdef SECOND_GLINT
  all += g.second.share * (which == 1 ? known : glintPdf(g.second, wi));
#endif
#ifdef THIRD_GLINT
  all += g.third.share * (which == 2 ? known : glintPdf(g.third, wi));
#endif
#ifdef FOURTH_GLINT
  all += g.fourth.share * (which == 3 ? known : glintPdf(g.fourth, wi));
#endif
  return all;
}

// Draws wi, as `bsdfSample` does, or towards a glint.
BsdfSample sampleWithGlints(Bsdf bsdf, vec3 wo, Glints g, vec2 u, float lobe) {
  float others = 1.0 - g.probability;
  if (lobe >= g.probability) {
    BsdfSample s = bsdfSample(bsdf, wo, u, (lobe - g.probability) / others);
    float pdf = s.pdf > 0.0 ? pdfWithGlints(g, s.wi, s.pdf, -1, 0.0) : 0.0;
    // A direction that no other could have been is none of a glint's.
    return BsdfSample(s.wi, s.weight * (s.pdf > 0.0 ? s.pdf / pdf : 1.0 / others), pdf);
  }
  int which = 0;
  GlintLobe chosen = g.first;
#ifdef SECOND_GLINT
  float end = g.first.share;
  if (lobe >= end) {
    which = 1;
    chosen = g.second;
  }
#endif
#ifdef THIRD_GLINT
  end += g.second.share;
  if (lobe >= end) {
    which = 2;
    chosen = g.third;
  }
#endif
#ifdef FOURTH_GLINT
  end += g.third.share;
  if (lobe >= end) {
    which = 3;
    chosen = g.fourth;
  }
#endif
  float known;
  float pdf;
  vec3 wi = glintSample(chosen, u, known);
  vec3 value = bsdfValue(bsdf, wo, wi, pdf);
  pdf = pdfWithGlints(g, wi, pdf, which, known);
  return BsdfSample(wi, value / max(pdf, SMALLEST), pdf);
}
