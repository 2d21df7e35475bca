/**
 * How different two pictures look, from 0 to 1: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström and
 * M. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020 (LDR-FLIP), with the constants of the
 * authors' own program.
 */

/** sRGB as it is shown, [0, 1], three numbers for each pixel. */
export interface ShownPicture {
  readonly width: number;
  readonly height: number;
  readonly data: ArrayLike<number>;
}

type Triple = readonly [number, number, number];

/** One number for each pixel. */
type Plane = Float64Array;

/** Pixels per degree: a 4K display 0.7 m wide, seen from 0.7 m. */
const PIXELS_PER_DEGREE = 67.02064514160156;
/** Exponent of colour distances, and where (of the largest one) the scale bends, at which height. */
const COLOR_POWER = 0.7;
const BEND = { at: 0.4, height: 0.95 } as const;
/** Width in degrees, and exponent, of the detectors of edges and points. */
const FEATURE = { width: 0.082, power: 0.5 } as const;

/** Section 4.1.1: contrast sensitivities as sums of two Gaussians, for luminance, red-green, blue-yellow. */
const SENSITIVITIES = [
  [{ a: 1, b: 0.0047 }],
  [{ a: 1, b: 0.0053 }],
  [
    { a: 34.1, b: 0.04 },
    { a: 13.5, b: 0.025 },
  ],
] as const;

const TO_XYZ: readonly [Triple, Triple, Triple] = [
  [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
  [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
  [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
];
const FROM_XYZ: readonly [Triple, Triple, Triple] = [
  [3.241003275, -1.537398934, -0.498615861],
  [-0.969224334, 1.875930071, 0.041554224],
  [0.055639423, -0.204011202, 1.057148933],
];

const times = (rows: readonly [Triple, Triple, Triple], [x, y, z]: Triple): Triple => {
  const row = ([a, b, c]: Triple): number => a * x + b * y + c * z;
  return [row(rows[0]), row(rows[1]), row(rows[2])];
};

const WHITE = times(TO_XYZ, [1, 1, 1]);

const linear = (s: number): number => (s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4);

/** The opponent space YCxCz, in which eyes blur. */
function toOpponent(rgb: Triple): Triple {
  const [x, y, z] = times(TO_XYZ, rgb).map((value, i) => value / (WHITE[i] as number)) as unknown as Triple;
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

function fromOpponent([luma, cx, cz]: Triple): Triple {
  const y = (luma + 16) / 116;
  const xyz = [y + cx / 500, y, y - cz / 200].map((value, i) => value * (WHITE[i] as number)) as unknown as Triple;
  return times(FROM_XYZ, xyz).map((value) => Math.min(Math.max(value, 0), 1)) as unknown as Triple;
}

/** L*a*b* with the Hunt effect: what is dark has less colour. */
function toHuntLab(rgb: Triple): Triple {
  const f = (t: number): number => (t > (6 / 29) ** 3 ? Math.cbrt(t) : t / (3 * (6 / 29) ** 2) + 4 / 29);
  const [x, y, z] = times(TO_XYZ, rgb).map((value, i) => f(value / (WHITE[i] as number))) as unknown as Triple;
  const l = 116 * y - 16;
  return [l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)];
}

/** HyAB: lightness apart from colour, which suits large differences. */
const distance = (a: Triple, b: Triple): number => Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);

const LARGEST = distance(toHuntLab([0, 1, 0]), toHuntLab([0, 0, 1])) ** COLOR_POWER;

/** Most of the scale is for the differences that occur: section 4.1.3. */
function colorDifference(a: Triple, b: Triple): number {
  const power = distance(a, b) ** COLOR_POWER;
  const bend = BEND.at * LARGEST;
  if (power < bend) return (power * BEND.height) / bend;
  return BEND.height + ((power - bend) / (LARGEST - bend)) * (1 - BEND.height);
}

/** A row of weights, symmetrical about its middle or not. */
type Kernel = readonly number[];

const gaussian = (radius: number, weight: (x: number) => number): Kernel =>
  Array.from({ length: 2 * radius + 1 }, (_, i) => weight(i - radius));

/** Convolves with a product of two rows; beyond its edges a picture goes on as it is there. */
function convolve({ width, height }: ShownPicture, plane: Plane, across: Kernel, down: Kernel): Plane {
  return along(along(plane, across, width, 1, height, width), down, height, width, width, 1);
}

/** Convolves `count` lines of `length` numbers, a number and a line being so far from the next. */
function along(from: Plane, kernel: Kernel, length: number, step: number, count: number, lineStep: number): Plane {
  const to = new Float64Array(from.length);
  const middle = kernel.length >> 1;
  for (let line = 0; line < count; line++) {
    for (let at = 0; at < length; at++) {
      let sum = 0;
      for (let k = 0; k < kernel.length; k++) {
        const inside = Math.min(Math.max(at + k - middle, 0), length - 1);
        sum += (kernel[k] as number) * (from[line * lineStep + inside * step] as number);
      }
      to[line * lineStep + at * step] = sum;
    }
  }
  return to;
}

/** What an eye sees of a channel. A sum of two Gaussians is no product of rows, but each of the two is. */
function blurred(picture: ShownPicture, plane: Plane, gaussians: (typeof SENSITIVITIES)[number]): Plane {
  const widest = Math.max(...SENSITIVITIES.flat().map(({ b }) => b));
  const radius = Math.ceil(3 * Math.sqrt(widest / (2 * Math.PI ** 2)) * PIXELS_PER_DEGREE);
  const parts = gaussians.map(({ a, b }) => {
    const kernel = gaussian(radius, (x) => Math.exp((-(Math.PI ** 2) * (x / PIXELS_PER_DEGREE) ** 2) / b));
    const sum = kernel.reduce((one, other) => one + other, 0);
    const strength = a * (Math.PI / b);
    return { plane: convolve(picture, plane, kernel, kernel), weight: strength, total: strength * sum ** 2 };
  });
  const total = parts.reduce((sum, part) => sum + part.total, 0);
  return plane.map((_, i) => parts.reduce((sum, part) => sum + part.weight * (part.plane[i] as number), 0) / total);
}

const triples = (planes: readonly Plane[]): readonly Triple[] =>
  Array.from(planes[0] as Plane, (_, i) => planes.map((plane) => plane[i]) as unknown as Triple);

const planesOf = (values: readonly Triple[]): readonly Plane[] =>
  [0, 1, 2].map((channel) => Float64Array.from(values, (value) => value[channel] as number));

/** Weights made to sum up to 1, those above and those below 0 each. */
function balanced(kernel: Kernel): Kernel {
  const sum = (sign: number): number => kernel.reduce((total, weight) => total + Math.max(sign * weight, 0), 0);
  const [above, below] = [sum(1), sum(-1)];
  return kernel.map((weight) => weight / (weight > 0 ? above : below || 1));
}

/** How strongly each pixel belongs to an edge, or to a point: section 4.2. */
function features(picture: ShownPicture, luma: Plane): { readonly edges: Plane; readonly points: Plane } {
  const deviation = 0.5 * FEATURE.width * PIXELS_PER_DEGREE;
  const radius = Math.ceil(3 * deviation);
  const weight = (x: number): number => Math.exp(-(x ** 2) / (2 * deviation ** 2));
  const smooth = balanced(gaussian(radius, weight));
  const length = (derivative: Kernel): Plane => {
    const across = convolve(picture, luma, derivative, smooth);
    const down = convolve(picture, luma, smooth, derivative);
    return across.map((value, i) => Math.hypot(value, down[i] as number));
  };
  return {
    edges: length(balanced(gaussian(radius, (x) => -x * weight(x)))),
    points: length(balanced(gaussian(radius, (x) => ((x / deviation) ** 2 - 1) * weight(x)))),
  };
}

type Perceived = ReturnType<typeof perceived>;

function perceived(picture: ShownPicture) {
  const opponent = Array.from({ length: picture.width * picture.height }, (_, i) =>
    toOpponent([0, 1, 2].map((channel) => linear(picture.data[3 * i + channel] as number)) as unknown as Triple),
  );
  const planes = planesOf(opponent);
  const seen = planes.map((plane, i) => blurred(picture, plane, SENSITIVITIES[i] as (typeof SENSITIVITIES)[number]));
  return {
    colors: triples(seen).map((color) => toHuntLab(fromOpponent(color))),
    ...features(
      picture,
      (planes[0] as Plane).map((luma) => (luma + 16) / 116),
    ),
  };
}

/** The difference of each pixel. */
export const flip = (one: ShownPicture, other: ShownPicture): Plane => apartness(perceived(one), perceived(other));

function apartness(a: Perceived, b: Perceived): Plane {
  const apart = (p: Plane, q: Plane, i: number): number => Math.abs((p[i] as number) - (q[i] as number));
  return Float64Array.from(a.colors, (color, i) => {
    const feature = (Math.max(apart(a.edges, b.edges, i), apart(a.points, b.points, i)) / Math.SQRT2) ** FEATURE.power;
    return colorDifference(color, b.colors[i] as Triple) ** (1 - feature);
  });
}

/** The mean over all pixels. Of many pictures against one, that one is looked at once. */
export function meanFlipTo(right: ShownPicture): (picture: ShownPicture) => number {
  const seen = perceived(right);
  return (picture) => average(apartness(perceived(picture), seen));
}

const average = (values: Plane): number => values.reduce((sum, value) => sum + value, 0) / values.length;
