/**
 * `npm run bench -- --frames`: whether an element keeps to its `frame-budget` while somebody drags the camera of a heavy
 * scene round. A frame counts as over where the work that was begun in it took longer than the budget and one tile more,
 * which is the least that can be drawn: both as the renderer's own clock tells.
 */
import type { BenchBrowser } from './browser-pages.ts';
import type { Drag, Work } from './frames-page.ts';

declare const frames: typeof import('./frames-page.ts');

/** The module of the pages that this runs in. */
export const FRAMES_PAGE = { entry: 'test/bench/frames-page.ts', name: 'frames' } as const;

/** `budget` is the default of `frame-budget`. */
const DRAG: Omit<Drag, 'scene'> = { budget: 12, width: 600, height: 400, frames: 200 };

/** Share of the frames that may be over. */
export const MOST_OVER = 0.02;

export interface Frames {
  /** Those in which work was begun: none is while the GPU is behind. */
  readonly frames: number;
  readonly over: number;
  /** Milliseconds of work in a frame: median, and what one in fifty exceeds. */
  readonly workMs: number;
  readonly workMs98: number;
  readonly tileMs: number;
  /** Pixels that were drawn in a frame, median. */
  readonly pixels: number;
}

export async function measureFrames(
  browser: BenchBrowser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
): Promise<{ readonly [scene: string]: Frames }> {
  printHead();
  const results: { [scene: string]: Frames } = {};
  for (const { name, scene } of scenes) {
    const page = await browser.open();
    const work = await page.execute((task) => frames.drag(task), { ...DRAG, scene });
    results[name] = framesOf(work);
    print(name, results[name]);
  }
  printFoot(Object.values(results));
  return results;
}

function framesOf(work: readonly Work[]): Frames {
  const at = (share: number, of: (one: Work) => number): number =>
    work.map(of).sort((a, b) => a - b)[Math.floor(share * (work.length - 1))] as number;
  const time = ({ milliseconds }: Work): number => milliseconds;
  return {
    frames: work.length,
    over: work.filter(({ milliseconds, tileMs }) => milliseconds > DRAG.budget + tileMs).length,
    workMs: at(0.5, time),
    workMs98: at(0.98, time),
    tileMs: at(0.5, ({ tileMs }) => tileMs),
    pixels: at(0.5, ({ pixels }) => pixels),
  };
}

const WIDTH = 11;

const line = (name: string, cells: readonly (number | string)[]): void =>
  console.log(name.padEnd(16) + cells.map((cell) => String(cell).padStart(WIDTH)).join(''));

function printHead(): void {
  const { budget, width, height } = DRAG;
  console.log(`\nA drag over ${width} × ${height} pixels with a budget of ${budget} ms: work of a frame`);
  line('', ['frames', 'over', 'ms', '98 %', 'tile ms', 'pixels']);
}

function print(name: string, { frames: count, over, workMs, workMs98, tileMs, pixels }: Frames): void {
  line(name, [count, over, workMs.toFixed(1), workMs98.toFixed(1), tileMs.toFixed(1), pixels]);
}

function printFoot(results: readonly Frames[]): void {
  const sum = (of: (one: Frames) => number): number => results.reduce((total, one) => total + of(one), 0);
  const share = sum(({ over }) => over) / sum(({ frames: count }) => count);
  const limit = `${(100 * MOST_OVER).toFixed(0)} %`;
  console.log(`over: ${(100 * share).toFixed(1)} %, ${share < MOST_OVER ? 'below' : 'NOT BELOW'} ${limit}`);
}
