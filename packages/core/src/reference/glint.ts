/**
 * Twin of shaders/glint.glsl: directions in which a ball with a narrow lobe shows a lamp without extent. Directions are in
 * the frame of the surface that they leave.
 */
import type { Glint } from '../glints.ts';
import { add, addScaled, cross, dot, length, scale, subtract, type Vec3 } from '../vector.ts';
import { circle } from './circle.ts';
import { type Bsdf, type BsdfSample, bsdfSample, bsdfValue, isMirrorOnly } from './material/bsdf.ts';
import type { PathScene } from './path-scene.ts';
import { type SurfaceFrame, toLocal } from './surface-frame.ts';
import { tangents } from './tangents.ts';
import type { Vertex } from './vertex.ts';

/** Directions around an axis, whose slopes along two others are spread as those of GGX facets are. */
export interface GlintLobe {
  readonly axis: Vec3;
  readonly along: Vec3;
  readonly across: Vec3;
  /** The slopes along them that stand for alpha. */
  readonly widths: readonly [along: number, across: number];
  /** What comes this way by the pair, roughly: irradiance on a surface that faces it, over that of all lamps. */
  readonly irradiance: number;
}

/** What a path may look for where it is. */
export interface Glints {
  readonly lobes: readonly GlintLobe[];
  /** The probability with which each is drawn from; else the BSDF is. */
  readonly shares: readonly number[];
  /** Their sum. */
  readonly probability: number;
}

export const NO_GLINTS: Glints = { lobes: [], shares: [], probability: 0 };

/** What is looked for at most. */
const MOST_PROBABLE = 0.5;

/** The radiance, over the irradiance of all lamps, at which a glint is looked for in half of the cases. */
const EVEN_RADIANCE = 0.064;

/** The least angle, 2^-18 exactly: directions in f32 are 16 times as dense. */
const NARROWEST = 3.814697265625e-6;

/** Of Newton's method. */
const STEPS = 4;

/** Where on the ball, seen from its centre as an angle from the surface with cosine c and sine s, and what it mirrors there. */
interface Incidence {
  /** To the surface over that from the centre to it, and to the lamp alike. */
  readonly distances: readonly [toSurface: number, toLamp: number];
  /** Of the angles of incidence. */
  readonly cosines: readonly [toSurface: number, toLamp: number];
  readonly sines: readonly [toSurface: number, toLamp: number];
}

/** g and h are the inverse distances of the surface and the lamp from the centre, in radii; the lamp is at the angle `lamp`. */
function incidenceAt([c, s]: Angle, lamp: Angle, g: number, h: number): Incidence {
  const cl = lamp[0] * c + lamp[1] * s;
  const sl = lamp[1] * c - lamp[0] * s;
  const x = Math.sqrt((c - g) ** 2 + s * s);
  const l = Math.sqrt((cl - h) ** 2 + sl * sl);
  return { distances: [x, l], cosines: [(c - g) / x, (cl - h) / l], sines: [s / x, sl / l] };
}

type Angle = readonly [cosine: number, sine: number];

function angleOf(c: number, s: number): Angle {
  const size = Math.sqrt(c * c + s * s);
  return [c / size, s / size];
}

/** The lobe of a pair at a point; undefined where the ball does not mirror the lamp to it. */
export function glintLobe(glint: Glint, p: Vec3, frame: SurfaceFrame): GlintLobe | undefined {
  const toPoint = toLocal(frame, subtract(p, glint.center));
  const toLamp = toLocal(frame, glint.toLamp);
  const away = length(toPoint);
  const [g, h] = [glint.radius / away, glint.nearness];
  if (!(g < 1 && h < 1)) return undefined;
  // The plane of the centre, the surface and the lamp.
  const x = scale(toPoint, 1 / away);
  const turn = cross(x, toLamp);
  const bent = length(turn);
  // Where it is hardly bent, any plane will do.
  const across = bent > NARROWEST ? scale(turn, 1 / bent) : tangents(x)[0];
  const y = cross(across, x);
  const lamp: Angle = [dot(x, toLamp), bent];
  let angle = angleOf(1 - h + (1 - g) * lamp[0], (1 - g) * lamp[1]);
  let place = incidenceAt(angle, lamp, g, h);
  for (let i = 0; i < STEPS; i++) {
    const { distances, cosines: c, sines: s } = place;
    // The tangent of half of what the angles differ by, over what a step changes of that.
    const over = 2 * (s[0] * c[1] - c[0] * s[1]);
    const under = (2 + (c[0] * g) / distances[0] + (c[1] * h) / distances[1]) * (1 + c[0] * c[1] + s[0] * s[1]);
    angle = angleOf(angle[0] * under + angle[1] * over, angle[1] * under - angle[0] * over);
    place = incidenceAt(angle, lamp, g, h);
  }
  const [cosine, cosineL] = place.cosines;
  const [sine] = place.sines;
  const [distance, distanceL] = place.distances;
  if (!(cosine > 0 && cosineL > 0)) return undefined;
  const near = g / distance;
  const bend = near + h / distanceL;
  // From the surface to the place: of unit length, however near.
  const [a, b] = [-cosine * angle[0] - sine * angle[1], sine * angle[0] - cosine * angle[1]];
  const [tangential, sagittal] = [2 + cosine * bend, 2 * cosine + bend];
  return {
    axis: add(scale(x, a), scale(y, b)),
    along: add(scale(x, -b), scale(y, a)),
    across,
    widths: [
      Math.max((2 * glint.alpha * cosine * near) / tangential, NARROWEST),
      Math.max((2 * glint.alpha * cosine * near) / sagittal, NARROWEST),
    ],
    irradiance: (glint.strength * cosine * near * near) / (tangential * sagittal),
  };
}

/** Per solid angle. */
export function glintPdf({ axis, along, across, widths: [a, b] }: GlintLobe, d: Vec3): number {
  const c = dot(d, axis);
  if (!(c > 0)) return 0;
  const square = c * c + (dot(d, along) / a) ** 2 + (dot(d, across) / b) ** 2;
  return c / (Math.PI * a * b * square * square);
}

/** A unit direction, with its pdf: that of the slopes, not of the direction, whose rounding makes much of a narrow lobe. */
export function glintSample(
  { axis, along, across, widths: [a, b] }: GlintLobe,
  u: readonly [number, number],
): { readonly wi: Vec3; readonly pdf: number } {
  const [x, y] = circle(u[0]);
  const slope = Math.sqrt(u[1] / (1 - u[1]));
  const [sx, sy] = [slope * x * a, slope * y * b];
  const size = Math.sqrt(1 + sx * sx + sy * sy);
  const rest = 1 - u[1];
  return {
    wi: scale(addScaled(addScaled(axis, along, sx), across, sy), 1 / size),
    pdf: (rest * rest * (size * size * size)) / (Math.PI * a * b),
  };
}

/** What there is to look for at a vertex, more often the more it would bring. */
export function glintsAt(scene: PathScene, { position, frame, object }: Vertex, bsdf: Bsdf, wo: Vec3): Glints {
  if (isMirrorOnly(bsdf)) return NO_GLINTS;
  const lobes = scene.glints
    .filter((glint) => glint.object !== object)
    .map((glint) => glintLobe(glint, position, frame))
    .filter((lobe) => lobe !== undefined)
    .filter(({ axis }) => axis[2] > 0);
  const radiances = lobes.map(({ axis, irradiance }) => {
    const [r, g, b] = bsdfValue(bsdf, wo, axis).value;
    return (irradiance * (r + g + b)) / 3;
  });
  const all = radiances.reduce((sum, one) => sum + one, 0);
  if (!(all > 0)) return NO_GLINTS;
  const probability = Math.min(all / (all + EVEN_RADIANCE), MOST_PROBABLE);
  return { lobes, shares: radiances.map((one) => (one / all) * probability), probability };
}

/** The pdf of a direction that the BSDF is drawn with `pdf`, by whatever way it was found. */
export const pdfWithGlints = ({ lobes, shares, probability }: Glints, wi: Vec3, pdf: number): number =>
  lobes.reduce((sum, lobe, i) => sum + (shares[i] as number) * glintPdf(lobe, wi), (1 - probability) * pdf);

/** Draws wi, as `bsdfSample` does, or towards a glint. */
export function sampleWithGlints(
  bsdf: Bsdf,
  wo: Vec3,
  glints: Glints,
  u: readonly [number, number],
  lobe: number,
): BsdfSample {
  const { lobes, shares, probability } = glints;
  if (lobe >= probability) {
    const sample = bsdfSample(bsdf, wo, u, (lobe - probability) / (1 - probability));
    // A direction that no other could have been is none of a glint's.
    if (sample.pdf === 0) return { ...sample, weight: scale(sample.weight, 1 / (1 - probability)) };
    const pdf = pdfWithGlints(glints, sample.wi, sample.pdf);
    return { wi: sample.wi, weight: scale(sample.weight, sample.pdf / pdf), pdf };
  }
  let rest = lobe;
  let which = 0;
  while (which < lobes.length - 1 && rest >= (shares[which] as number)) rest -= shares[which++] as number;
  const { wi, pdf: own } = glintSample(lobes[which] as GlintLobe, u);
  const { value, pdf: bsdfPdf } = bsdfValue(bsdf, wo, wi);
  const pdf = lobes.reduce(
    (sum, one, i) => sum + (shares[i] as number) * (i === which ? own : glintPdf(one, wi)),
    (1 - probability) * bsdfPdf,
  );
  return { wi, weight: scale(value, 1 / pdf), pdf };
}
