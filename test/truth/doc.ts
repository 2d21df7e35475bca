/**
 * The measured tables of docs/how-exact.md, written by `npm run truth -- --only vectors --doc docs/how-exact.md`, and by
 * `--only images`.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { type ImageRow, percent } from './images/judge-image.ts';
import type { Truth } from './report.ts';
import type { VectorRow } from './rows.ts';

/**
 * Writes what was measured between the marks of a Markdown file: of vectors after `<!-- measured -->`, of images after
 * `<!-- measured pictures -->`. @throws {Error} when it does not have them.
 */
export function writeDoc(file: string, truth: Truth): void {
  let text = readFileSync(file, 'utf8');
  if (truth.vectors.length > 0) text = withTable(text, 'measured', measuredText(truth));
  if (truth.images.length > 0) text = withTable(text, 'measured pictures', picturesText(truth.images));
  writeFileSync(file, text);
}

function withTable(text: string, what: string, table: string): string {
  const [start, end] = [`<!-- ${what} -->\n`, `<!-- end of ${what} -->`];
  const [from, to] = [text.indexOf(start), text.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`there is no place for the table, from ${start.trim()} to ${end}`);
  return text.slice(0, from + start.length) + table + text.slice(to);
}

const SIDES = ['reference', 'gpu-camera', 'gpu-secondary'] as const;

const HEAD = `| primitive | regime | cases | f64 | | camera path | | secondary path | | textbook | | |
| --- | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |
| | | | p99 | max | p99 | max | p99 | max | wrong | p99 | max |
`;

function measuredText({ vectors, watertight, textbook, broken }: Truth): string {
  const groups = textbook.length > 0 || vectors.length > 0 ? keysOf(vectors) : [];
  const lines = groups.map(([primitive, regime]) => {
    const find = (rows: readonly VectorRow[], side: string): VectorRow | undefined =>
      rows.find((row) => row.side === side && row.primitive === primitive && row.regime === regime);
    const cases = find(vectors, 'gpu-camera')?.cases ?? find(vectors, 'reference')?.cases ?? 0;
    const ours = SIDES.flatMap((side) => errorCells(find(vectors, side)));
    const theirs = find(textbook, 'textbook');
    const cells = [primitive, regime, cases, ...ours, theirs?.wrong ?? '', ...errorCells(theirs)];
    return `| ${cells.join(' | ')} |\n`;
  });
  const wrong = SIDES.map((side) => `${sum(vectors.filter((row) => row.side === side))} (${side})`).join(', ');
  const leaks = watertight.map(({ side, cases, lost }) => `${lost} of ${cases} (${side})`).join(', ');
  const verdict = broken.length > 0 ? `Limits broken: ${broken.join('; ')}.` : 'All limits are kept.';
  return `\n${HEAD}${lines.join('')}\nWrong hits: ${wrong}. Rays lost between triangles: ${leaks}. ${verdict}\n\n`;
}

const sum = (rows: readonly VectorRow[]): number => rows.reduce((total, { wrong }) => total + wrong, 0);

/** Every primitive with every regime that it was measured in, in their order. */
function keysOf(rows: readonly VectorRow[]): readonly (readonly [string, string])[] {
  const keys = new Map(rows.map(({ primitive, regime }) => [`${primitive}/${regime}`, [primitive, regime] as const]));
  return [...keys.values()];
}

const errorCells = (row: VectorRow | undefined): readonly string[] =>
  row ? [short(row.p99), short(row.max)] : ['', ''];

const short = (value: number): string => (value < 1000 ? value.toPrecision(2) : value.toExponential(0));

const PICTURES_HEAD = `| scene | side | samples | bias | ± | rms z | of all | expected | errors | left out | PSNR | minutes |
| --- | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |
`;

function picturesText(rows: readonly ImageRow[]): string {
  const broken = rows.flatMap(({ scene, side, broken: limits }) =>
    limits.map((limit) => `${scene}, ${side}: ${limit}`),
  );
  const verdict = broken.length > 0 ? `Limits broken: ${broken.join('; ')}.` : 'All limits are kept.';
  return `\n${PICTURES_HEAD}${rows.map(pictureLine).join('')}\n${verdict}\n\n`;
}

function pictureLine(row: ImageRow): string {
  const { scene, side, skipped } = row;
  if (skipped !== null) return `| ${scene} | ${side} | ${skipped} | | | | | | | | | |\n`;
  const shares = [row.bias, row.biasError].map((share) => percent(share ?? 0));
  const ratios = [row.rmsZ, row.rmsZAll, row.expectedRmsZ, row.errorRatio].map((ratio) => (ratio ?? 0).toFixed(2));
  // JSON has no word for an infinite one.
  const decibels = Number.isFinite(row.psnr) ? row.psnr?.toFixed(1) : 'exact';
  const rest = [percent(row.skippedFraction ?? 0), decibels, (row.minutes ?? 0).toFixed(1)];
  return `| ${[scene, side, row.samples, ...shares, ...ratios, ...rest].join(' | ')} |\n`;
}
