/** Time against error as pictures, drawn by Observable Plot into a document that is none. */
import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { type Choice, frontOf } from './front.ts';
import type { Preset } from './presets.ts';

const WIDTH = 720;
const HEIGHT = 440;

interface Mark extends Choice {
  readonly group: string;
  /** In percent. */
  readonly percent: number;
}

const groupOf = ({ setting: { integrator, scale } }: Choice): string => (scale < 1 ? 'fewer pixels' : integrator);

const markOf = (choice: Choice): Mark => ({ ...choice, group: groupOf(choice), percent: 100 * choice.error });

/** Those far enough from the one before for a label each. */
function labelled(front: readonly Mark[]): readonly Mark[] {
  const kept: Mark[] = [];
  for (const mark of front) {
    const last = kept.at(-1);
    if (!last || mark.error < last.error / 1.18) kept.push(mark);
  }
  return kept;
}

/** One line for each setting, a dot for each number of samples, a ring where none were drawn; the front is over them. */
export function plotTrade(choices: readonly Choice[], presets: readonly Preset[] = []): string {
  const marks = choices.map(markOf);
  const front = frontOf(choices).map(markOf);
  const standing = presets.flatMap(({ quality, standing: choice }) => (choice ? [{ ...markOf(choice), quality }] : []));
  const { document } = parseHTML('<html></html>');
  const place = { x: 'milliseconds', y: 'percent' } as const;
  const svg = Plot.plot({
    document,
    width: WIDTH,
    height: HEIGHT,
    marginLeft: 60,
    marginRight: 40,
    grid: true,
    style: { background: 'white', color: 'black' },
    x: { type: 'log', label: 'ms for a picture of 96 × 64 →' },
    y: { type: 'log', label: '↑ error, % (noise and bias together)', tickFormat: '~r' },
    color: {
      domain: ['path', 'direct', 'fewer pixels', 'not drawn'],
      range: ['#1f77b4', '#d95f02', '#999999', 'white'],
      legend: false,
    },
    marks: [
      Plot.line(marks, { ...place, z: 'name', stroke: 'group', strokeOpacity: 0.35 }),
      Plot.dot(marks, {
        ...place,
        stroke: 'group',
        fill: (mark: Mark) => (mark.measured ? mark.group : 'not drawn'),
        r: 2.5,
        title: (mark: Mark) => `${mark.name}, ${mark.samples} samples`,
      }),
      Plot.line(front, { ...place, stroke: 'black', strokeWidth: 2, curve: 'step-after' }),
      Plot.text(labelled(front), {
        ...place,
        text: (mark: Mark) => `${mark.name}, ${mark.samples}`,
        dy: 8,
        dx: 4,
        textAnchor: 'start',
        fontSize: 9,
      }),
      Plot.dot(standing, { ...place, r: 6, stroke: 'black', fill: 'none' }),
      Plot.text(standing, { ...place, text: 'quality', dy: -14, fontWeight: 'bold', stroke: 'white', fill: 'black' }),
    ],
  });
  // In a file by itself it must say what it is.
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return `${svg.outerHTML}\n`;
}
