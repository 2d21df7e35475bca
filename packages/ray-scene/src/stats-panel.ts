/** The panel of `show-stats`: how far the picture is, what it cost, and how its error falls with time. */
import type { RenderSettings } from '@ray-scene/core';
import { adoptStyles } from './adopt-styles.ts';
import type { RenderStats } from './renderer.ts';

/** What is told, by whom. */
export interface StatsHost extends HTMLElement {
  readonly settings: RenderSettings;
  readonly stats: RenderStats | undefined;
}

const style = `
  [part='stats'] {
    position: absolute;
    inset: 0 auto auto 0;
    box-sizing: border-box;
    max-width: 100%;
    max-height: 100%;
    padding: 0.5em 0.75em;
    overflow: auto;
    pointer-events: none;
    font: 0.75rem / 1.4 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
    color: var(--ray-scene-stats-color, #fff);
    background: var(--ray-scene-stats-background, rgb(0 0 0 / 65%));
  }
  [part='stats'] dl {
    display: grid;
    grid-template-columns: auto auto;
    gap: 0 0.75em;
    margin: 0;
  }
  [part='stats'] dd {
    margin: 0;
    text-align: end;
  }
  [part='stats-curve'] {
    display: block;
    width: 12em;
    height: 4em;
    fill: none;
    stroke: currentcolor;
  }
`;

/** Milliseconds between two looks at the numbers: people read no faster. */
const PAUSE_MS = 200;

/** Of the curve, in its own units; one more decade of time or error is one more step of the grid. */
const WIDTH = 120;
const HEIGHT = 40;

const SVG = 'http://www.w3.org/2000/svg';

/** A number in as many digits as mean something. */
const digits = (x: number): string => Number(x.toPrecision(x < 100 ? 2 : 3)).toLocaleString('en');

const percent = (x: number): string => `${digits(100 * x)} %`;

/** A rule that may end a picture: how much of the way to its end is done, and how that reads. */
interface Rule {
  readonly done: number;
  readonly text: string;
}

/** The rules of these settings. Noise falls with the root of time, so the share of the time is that of its square. */
export function stopRules({ samples, error, seconds }: RenderStats, settings: RenderSettings): readonly Rule[] {
  const { maxError, maxTime } = settings;
  return [
    { done: samples / settings.samples, text: `${settings.samples.toLocaleString('en')} samples` },
    ...(maxError && error ? [{ done: (maxError / error) ** 2, text: `an error of ${percent(maxError)}` }] : []),
    ...(maxTime ? [{ done: seconds / maxTime, text: `${digits(maxTime)} s` }] : []),
  ];
}

/** One point of the curve. */
export interface Point {
  readonly seconds: number;
  readonly error: number;
}

/** The curve as points of an SVG polyline: logarithms of time and error, from the first point to the last. */
export function curveOf(points: readonly Point[]): string {
  const scaled = (key: keyof Point) => {
    const logs = points.map((point) => Math.log(point[key]));
    const [least, most] = [Math.min(...logs), Math.max(...logs)];
    return logs.map((log) => (most > least ? (log - least) / (most - least) : 0));
  };
  const [along, up] = [scaled('seconds'), scaled('error')];
  return along.map((x, i) => `${(x * WIDTH).toFixed(1)},${((1 - (up[i] as number)) * HEIGHT).toFixed(1)}`).join(' ');
}

export class StatsPanel {
  readonly #host: StatsHost;
  readonly #root: ShadowRoot;
  readonly #panel = document.createElement('div');
  readonly #list = document.createElement('dl');
  readonly #curve = document.createElementNS(SVG, 'svg');
  readonly #line = document.createElementNS(SVG, 'polyline');
  #points: Point[] = [];
  #shownAt = Number.NEGATIVE_INFINITY;

  constructor(host: StatsHost, root: ShadowRoot) {
    this.#host = host;
    this.#root = root;
    // A group that can be read when one comes to it; numbers that change all the time are not to be called out.
    for (const [name, value] of Object.entries({
      part: 'stats',
      role: 'group',
      'aria-label': 'How the picture is made',
    })) {
      this.#panel.setAttribute(name, value);
    }
    this.#curve.setAttribute('part', 'stats-curve');
    this.#curve.setAttribute('role', 'img');
    this.#curve.setAttribute('viewBox', `-2 -2 ${WIDTH + 4} ${HEIGHT + 4}`);
    this.#curve.append(this.#line);
    this.#panel.append(this.#list, this.#curve);
    root.append(this.#panel);
    for (const type of ['progress', 'complete'] as const) host.addEventListener(type, this);
    this.#show(false);
  }

  /** To be told after every update, as the element may have come into another document. */
  set hidden(hidden: boolean) {
    adoptStyles(this.#root, style);
    if (hidden === this.#panel.hidden) return;
    this.#panel.hidden = hidden;
    this.#show(false);
  }

  handleEvent({ type, timeStamp }: Event): void {
    const isOver = type === 'complete';
    if (isOver || timeStamp - this.#shownAt > PAUSE_MS) this.#show(isOver, timeStamp);
  }

  #show(isOver: boolean, now = performance.now()): void {
    const { stats, settings } = this.#host;
    if (!stats || this.#panel.hidden) return;
    this.#shownAt = now;
    const nearest = stopRules(stats, settings).reduce((a, b) => (b.done > a.done ? b : a));
    this.#tell({
      samples: stats.samples.toLocaleString('en'),
      error: stats.error === undefined ? '…' : percent(stats.error),
      time: `${stats.seconds.toFixed(1)} s`,
      'a sample takes': `${digits(stats.msPerSample)} ms`,
      size: `${stats.width} × ${stats.height}`,
      [isOver ? 'ended by' : 'ends at']: isOver
        ? nearest.text
        : `${nearest.text} (${Math.min(100, Math.floor(100 * nearest.done))} %)`,
    });
    this.#draw(stats);
  }

  #tell(rows: { readonly [name: string]: string }): void {
    const cells = Object.entries(rows).flatMap(([name, value]) => {
      const [term, text] = [document.createElement('dt'), document.createElement('dd')];
      term.textContent = name;
      text.textContent = value;
      return [term, text];
    });
    this.#list.replaceChildren(...cells);
  }

  #draw({ seconds, error }: RenderStats): void {
    const last = this.#points.at(-1);
    // Time that went back is that of another picture.
    if (last && seconds < last.seconds) this.#points = [];
    if (error && seconds > 0 && error !== this.#points.at(-1)?.error) this.#points.push({ seconds, error });
    const [first, end] = [this.#points[0], this.#points.at(-1)];
    this.#curve.toggleAttribute('hidden', this.#points.length < 2);
    this.#line.setAttribute('points', curveOf(this.#points));
    if (first && end) {
      const text = `The error fell from ${percent(first.error)} to ${percent(end.error)} in ${digits(end.seconds)} seconds.`;
      this.#curve.setAttribute('aria-label', text);
    }
  }
}
