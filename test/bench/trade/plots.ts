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

/** One line for each setting, a dot for each number of samples; the front is drawn over them. */
export function plotTrade(choices: readonly Choice[], presets: readonly Preset[] = []): string {
  const measured = choices.filter((choice) => choice.measured);
  const marks = measured.map(markOf);
  const front = frontOf(measured).map(markOf);
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
    color: { domain: ['path', 'direct', 'fewer pixels'], range: ['#1f77b4', '#d95f02', '#999999'], legend: false },
    marks: [
      Plot.line(marks, { ...place, z: 'name', stroke: 'group', strokeOpacity: 0.35 }),
      Plot.dot(marks, {
        ...place,
        fill: 'group',
        r: 2.5,
        title: (mark: Mark) => `${mark.name}, ${mark.samples} samples`,
      }),
      Plot.line(front, { ...place, stroke: 'black', strokeWidth: 2, curve: 'step-after' }),
      Plot.text(front, {
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
