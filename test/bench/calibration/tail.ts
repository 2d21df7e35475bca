/** The true noise of pictures, whether their variance is finite as far as they tell, and how many pixels hold it. */
import { relativeTo, type Spread } from '../trade/statistics.ts';

/** Root of the mean of variance / (mean² + ε), the mean being that of the pictures that are known best. */
export function relativeNoise(spread: Spread, best: Spread): number {
  let sum = 0;
  for (let i = 0; i < spread.length; i++) sum += spread.variance(i) / relativeTo(best.mean(i));
  return Math.sqrt(sum / spread.length);
}

/**
 * How many pixels hold the variance: as many as if it were the same in those and nothing in others, (Σ v)² / Σ v² of the
 * relative variances v of pixels (the participation ratio).
 */
export function noisyPixels(spread: Spread, best: Spread): number {
  let sum = 0;
  let squares = 0;
  for (let i = 0; i < spread.length; i += 3) {
    const ofPixel = [i, i + 1, i + 2].reduce((total, at) => total + spread.variance(at) / relativeTo(best.mean(at)), 0);
    sum += ofPixel;
    squares += ofPixel ** 2;
  }
  return sum ** 2 / squares;
}

/**
 * How fast large errors become rare: where one larger than x has a probability in proportion to x^-α, the index is α. The
 * variance is finite if it is above 2, and only then can noise be told in advance. Of the errors of all pixels of all
 * pictures, each that of the channel that is off most, the largest √n are looked at, which is the usual number.
 * Source: B. M. Hill, "A Simple General Approach to Inference About the Tail of a Distribution", Annals of Statistics 3(5),
 * 1975, equation 2.7 without its correction.
 */
export function tailIndex(pictures: readonly ArrayLike<number>[], spread: Spread): number {
  const errors = pictures.flatMap((picture) => errorsOf(picture, spread)).filter((error) => error > 0);
  const sorted = Float64Array.from(errors).sort().reverse();
  const count = Math.round(Math.sqrt(sorted.length));
  const least = sorted[count] as number;
  const sum = sorted.subarray(0, count).reduce((total, error) => total + Math.log(error / least), 0);
  return count / sum;
}

/** Each against the mean of the other pictures: a rare error would make that large which it is compared with. */
function errorsOf(picture: ArrayLike<number>, spread: Spread): readonly number[] {
  const { count } = spread;
  const error = (i: number): number => {
    const value = picture[i] as number;
    const others = (count * spread.mean(i) - value) / (count - 1);
    return Math.abs(value - others) / Math.sqrt(relativeTo(others));
  };
  return Array.from({ length: picture.length / 3 }, (_, i) =>
    Math.max(error(3 * i), error(3 * i + 1), error(3 * i + 2)),
  );
}
