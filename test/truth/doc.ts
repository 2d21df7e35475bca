/** The measured table of docs/how-exact.md, written by `npm run truth -- --only vectors --doc docs/how-exact.md`. */
import { readFileSync, writeFileSync } from 'node:fs';
import type { Truth } from './report.ts';
import type { VectorRow } from './rows.ts';

const START = '<!-- measured -->\n';
const END = '<!-- end of measured -->';

/** Writes the table between the two marks of a Markdown file. @throws {Error} when it does not have them. */
export function writeDoc(file: string, truth: Truth): void {
  const text = readFileSync(file, 'utf8');
  const [from, to] = [text.indexOf(START), text.indexOf(END)];
  if (from < 0 || to < from) throw new Error(`${file} has no place for the table, from ${START.trim()} to ${END}`);
  writeFileSync(file, text.slice(0, from + START.length) + measuredText(truth) + text.slice(to));
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
