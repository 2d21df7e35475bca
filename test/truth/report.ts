/** The result as tables for people. */
import type { ImageRow } from './images/judge-image.ts';
import { type BrdfRow, limitsOf, type VectorRow, type WatertightRow } from './rows.ts';

/** What `--json` writes. Fields may be added, not renamed. */
export interface Truth {
  readonly vectors: readonly VectorRow[];
  readonly watertight: readonly WatertightRow[];
  readonly brdf: readonly BrdfRow[];
  readonly images: readonly ImageRow[];
  /** What textbook code gets in f32, as rows of `vectors`. */
  readonly textbook: readonly VectorRow[];
  /** What there was no code for. */
  readonly skipped: readonly string[];
  /** The limits that are not kept, in words. */
  readonly broken: readonly string[];
}

const COLUMNS = ['cases', 'wrong', 'p50', 'p90', 'p99', 'max', 'raw p99', 'normal p99', 'textbook', 'p99', 'max'];

const IMAGE_COLUMNS = [
  'images',
  'samples',
  'bias',
  '± error',
  'rms z',
  'of all',
  'expected',
  'errors',
  'dB',
  'minutes',
];

export function printReport({ vectors, watertight, brdf, images, textbook, skipped, broken }: Truth): void {
  for (const side of new Set(vectors.map((row) => row.side))) {
    const rows = vectors.filter((row) => row.side === side);
    console.log(`\n${side}: errors of t in units of its conditioning${side === 'reference' ? ' in f64' : ''}`);
    console.log(line(['', ...(side === 'gpu-camera' ? COLUMNS : COLUMNS.slice(0, 8))]));
    for (const row of rows) {
      const beside = side === 'gpu-camera' ? textbook.find((one) => sameCases(one, row)) : undefined;
      console.log(
        line([`${row.primitive} ${row.regime}`, ...vectorCells(row), ...(beside ? textbookCells(beside) : [])]),
      );
    }
  }
  if (watertight.length > 0) console.log(`\nwatertight${' '.repeat(22)}cases      lost`);
  for (const { side, cases, lost } of watertight) console.log(line([side, cases, lost]));
  if (brdf.length > 0) console.log(`\n${line(['brdf', 'cases', 'p99', 'max'])}`);
  for (const { side, table, cases, p99, max } of brdf)
    console.log(line([`${side} ${table}`, cases, short(p99), short(max)]));
  if (images.length > 0) console.log(`\n${line(IMAGE_COLUMNS)}`);
  for (const row of images) console.log(imageLine(row));
  if (skipped.length > 0) console.log(`\nskipped: ${skipped.join(', ')}`);
  console.log(broken.length > 0 ? `\nlimits broken:\n  ${broken.join('\n  ')}` : '\nall limits kept');
}

export const imageLine = (row: ImageRow): string => line(imageCells(row));

function imageCells(row: ImageRow): readonly (string | number)[] {
  const name = `${row.scene} ${row.side === 'gpu' ? 'gpu' : 'ref'}`;
  if (row.skipped !== null) return [name, `   skipped: ${row.skipped}`];
  const { samples, bias, biasError, rmsZ, rmsZAll, expectedRmsZ, errorRatio, psnr, minutes, broken } = row;
  const percents = [bias, biasError].map((share) => `${(100 * (share ?? 0)).toFixed(3)}%`);
  const ratios = [rmsZ, rmsZAll, expectedRmsZ, errorRatio].map((value) => (value ?? 0).toFixed(2));
  const marked = `${minutes?.toFixed(1)}${broken.length > 0 ? '!' : ''}`;
  return [name, samples ?? 0, ...percents, ...ratios, psnr?.toFixed(1) ?? '', marked];
}

const sameCases = (a: VectorRow, b: VectorRow): boolean => a.primitive === b.primitive && a.regime === b.regime;

function vectorCells(row: VectorRow): string[] {
  const { cases, wrong, p50, p90, p99, max, rawP99, normalP99 } = row;
  const limits = limitsOf(row);
  return [
    `${cases}`,
    `${wrong}`,
    short(p50),
    short(p90),
    short(p99) + (p99 <= limits.p99 ? '' : '!'),
    short(max) + (max <= limits.max ? '' : '!'),
    rawP99.toExponential(0),
    short(normalP99),
  ];
}

const textbookCells = ({ wrong, p99, max }: VectorRow): string[] => [`${wrong} wrong`, short(p99), short(max)];

const short = (value: number): string => (value < 1000 ? value.toPrecision(2) : value.toExponential(0));

const line = ([name, ...cells]: readonly (string | number)[]): string =>
  String(name).padEnd(26) + cells.map((cell) => String(cell).padStart(10)).join('');
