/** A picture of ours against another renderer's: the numbers of a row, and the limits that they are held to. */
import { average, type Estimate, type EstimateOptions, greyOf } from './estimate.ts';
import type { ImageTruth } from './image-truth.ts';

export type ImageSide = 'reference' | 'gpu';

/** What `--json` tells of a picture; all numbers are null where there is none. */
export interface ImageRow {
  readonly scene: string;
  readonly side: ImageSide;
  /** Per pixel. */
  readonly samples: number | null;
  /** Of the image's mean over pixels and channels, (ours - theirs) / theirs. */
  readonly bias: number | null;
  /** Standard error of the bias, from the spread of our batches and of theirs. */
  readonly biasError: number | null;
  /** The same of each channel. */
  readonly biasRgb: readonly number[] | null;
  /**
   * Root of the mean of z² (see `zScores`) over pixels that have noise, in ours or in theirs: the others agree to the last
   * digits, if rounding is all there is. Over all pixels if none has noise.
   */
  readonly rmsZ: number | null;
  /** The same over all pixels. */
  readonly rmsZAll: number | null;
  /** What it is on average if both are right: z has Student's distribution, since errors are estimates from n batches. */
  readonly expectedRmsZ: number | null;
  /** Share of the pixels that have noise. */
  readonly noisyFraction: number | null;
  readonly maxZ: number | null;
  /** Our mean standard error of a pixel in units of theirs. */
  readonly errorRatio: number | null;
  /** Share of pixels that are not finite, which are left out of all numbers. */
  readonly skippedFraction: number | null;
  /** In dB, of the sRGB pictures from 0 to 1. */
  readonly psnr: number | null;
  /** How long it took, on this machine. */
  readonly minutes: number | null;
  /** Why there is no picture. */
  readonly skipped: string | null;
  /** The limits that are not kept which say that the two pictures are not the same, in words. */
  readonly disagrees: readonly string[];
  /** All limits that are not kept. */
  readonly broken: readonly string[];
}

/** Below this share of its value a pixel's standard error counts as this: f32 says no more of a sum of many samples. */
const FLOOR = 1e-5;
/** Of our mean standard error in units of theirs, unless another limit is given. */
export const MAX_ERROR_RATIO = 3;
/** What is aimed at, with a margin for what the first samples do not tell; and where it ends in any case. Of the limit. */
const GOOD_ERRORS = 0.9;
const LEAST_ERRORS = 1 / 3;
const MAX_BIAS = 0.003;
const RMS_Z_RANGE = [0.9, 1.1] as const;
/** In floors, the noise of pixels that have noise: with less than this, z is made small by the floor. */
const NOISE = 3;

const floored = (error: number, value: number): number => Math.max(error, FLOOR * Math.abs(value));

/** Pixels that can be judged. */
function finitePixels(ours: Float64Array, theirs: Float64Array): readonly number[] {
  return [...ours.keys()].filter((i) => Number.isFinite(ours[i]) && Number.isFinite(theirs[i]));
}

/** (ours - theirs) / the standard error of that, of each pixel's grey mean. Not finite where a picture is not. */
export function zScores(ours: Estimate, theirs: ImageTruth): Float64Array {
  const [grey, right] = [greyOf(ours.rgb), greyOf(theirs.rgb)];
  return grey.map((value, i) => {
    const truth = right[i] as number;
    const error = Math.hypot(floored(ours.error[i] as number, value), floored(theirs.error[i] as number, truth));
    return error > 0 || !Number.isFinite(value) ? (value - truth) / error : 0;
  });
}

/** Our mean standard error of a pixel in units of theirs. */
export function errorRatio(ours: Estimate, theirs: ImageTruth): number {
  const [grey, right] = [greyOf(ours.rgb), greyOf(theirs.rgb)];
  const own = average(finitePixels(grey, right).map((i) => floored(ours.error[i] as number, grey[i] as number)));
  const other = average(right.map((value, i) => floored(theirs.error[i] as number, value)));
  return own / other;
}

/** @param mostErrors limit of our mean standard error, in units of theirs. */
export function imageRow(
  side: ImageSide,
  ours: Estimate,
  theirs: ImageTruth,
  mostErrors = MAX_ERROR_RATIO,
  minutes: number | null = null,
): ImageRow {
  const [grey, right] = [greyOf(ours.rgb), greyOf(theirs.rgb)];
  const pixels = finitePixels(grey, right);
  const z = zScores(ours, theirs);
  const noisy = pixels.filter((i) => {
    const error = Math.hypot(ours.error[i] as number, theirs.error[i] as number);
    return error > NOISE * FLOOR * Math.abs(right[i] as number);
  });
  const rms = (of: readonly number[]): number => Math.sqrt(average(of.map((i) => (z[i] as number) ** 2)));
  const channel = (c: number): number =>
    relative(
      average(pixels.map((i) => ours.rgb[3 * i + c] as number)),
      average(pixels.map((i) => theirs.rgb[3 * i + c] as number)),
    );
  const row = {
    scene: theirs.scene.name,
    side,
    samples: ours.samples,
    bias: relative(average(pixels.map((i) => grey[i] as number)), average(pixels.map((i) => right[i] as number))),
    biasError: Math.hypot(ours.meanError, theirs.meanError),
    biasRgb: [0, 1, 2].map(channel),
    rmsZ: rms(noisy.length > 0 ? noisy : pixels),
    rmsZAll: rms(pixels),
    expectedRmsZ: Math.sqrt((theirs.batches - 1) / (theirs.batches - 3)),
    noisyFraction: noisy.length / grey.length,
    maxZ: pixels.reduce((most, i) => Math.max(most, Math.abs(z[i] as number)), 0),
    errorRatio: errorRatio(ours, theirs),
    skippedFraction: 1 - pixels.length / grey.length,
    psnr: psnr(ours.rgb, theirs.rgb),
    minutes,
    skipped: null,
  };
  const disagrees = disagreements(row);
  const noise = row.errorRatio.toPrecision(3);
  const tooNoisy = row.errorRatio <= mostErrors ? [] : [`errors ${noise} times theirs, at most ${mostErrors}`];
  return { ...row, disagrees, broken: [...disagrees, ...tooNoisy] };
}

/**
 * How many times as many samples an estimate should have. Where few samples meet something rare, z is not normally
 * distributed: a pixel that none of them met it in seems to have no error. So what fails for its z has more.
 */
export function moreSamples(ours: Estimate, theirs: ImageTruth, mostErrors = MAX_ERROR_RATIO): number {
  const ratio = errorRatio(ours, theirs);
  if (!(ratio <= mostErrors)) return (ratio / (GOOD_ERRORS * mostErrors)) ** 2;
  const agrees = imageRow('reference', ours, theirs).disagrees.length === 0;
  return agrees || ratio <= LEAST_ERRORS * mostErrors ? 1 : 4;
}

/** What tests take: few samples, whose errors may be larger than those of the truth. */
export const fewSamples: EstimateOptions = { more: () => 2, mostSamples: 128 };

type Numbers = {
  readonly [K in
    | 'bias'
    | 'biasError'
    | 'rmsZ'
    | 'expectedRmsZ'
    | 'noisyFraction'
    | 'errorRatio'
    | 'skippedFraction']: number;
};

function disagreements(row: Numbers): readonly string[] {
  const { bias, biasError, rmsZ, expectedRmsZ, noisyFraction, skippedFraction } = row;
  // Without noise, pictures may agree to the last digit.
  const least = noisyFraction > 0 ? RMS_Z_RANGE[0] * expectedRmsZ : 0;
  const most = RMS_Z_RANGE[1] * expectedRmsZ;
  return [
    !(Math.abs(bias) < MAX_BIAS || Math.abs(bias) < 3 * biasError) &&
      `bias ${percent(bias)}, below ${percent(MAX_BIAS)} or 3 × ${percent(biasError)}`,
    !(rmsZ >= least && rmsZ <= most) && `rmsZ ${rmsZ.toFixed(3)}, ${least.toFixed(2)} to ${most.toFixed(2)}`,
    skippedFraction > 0 && `${percent(skippedFraction)} of the pixels not finite`,
  ].filter((what) => what !== false);
}

/** A picture that there is not. `broken`: there should be one. */
export const skippedRow = (scene: string, side: ImageSide, why: string, broken = false): ImageRow => ({
  scene,
  side,
  samples: null,
  bias: null,
  biasError: null,
  biasRgb: null,
  rmsZ: null,
  rmsZAll: null,
  expectedRmsZ: null,
  noisyFraction: null,
  maxZ: null,
  errorRatio: null,
  skippedFraction: null,
  psnr: null,
  minutes: null,
  skipped: why,
  disagrees: [],
  broken: broken ? [why] : [],
});

const relative = (ours: number, theirs: number): number => (theirs === 0 ? ours : ours / theirs - 1);

export const percent = (share: number): string => `${(100 * share).toFixed(3)} %`;

function psnr(ours: ArrayLike<number>, theirs: ArrayLike<number>): number {
  const squares = Array.from(ours, (value, i) => (encoded(value) - encoded(theirs[i] as number)) ** 2);
  return -10 * Math.log10(average(squares.filter(Number.isFinite)));
}

/** sRGB's transfer function (IEC 61966-2-1) on 0 to 1. */
export function encoded(linear: number): number {
  const x = Math.min(1, Math.max(0, linear));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}
