/**
 * `npm run bench -- --only calibration`: whether pictures know their noise. Every example, by both integrators, and every
 * scene of the truth is drawn many times with other random numbers.
 *
 * What counts are scenes of finite variance: those whose tail index (`tailIndex`) is above 2; and of them the rows whose noise
 * is that of so many pixels that chance leaves it within the limits: an estimate has one degree of freedom for each pixel
 * that is noisy. Both are told by the true errors alone. All rows are told, those that do not count as well. A very rare
 * event that no picture of a row met is not in its tail index either.
 */
import type { BenchBrowser } from '../browser-pages.ts';
import type { Stage } from './page.ts';
import { type BenchSubject, gallerySubjects, truthSubjects } from './subjects.ts';

declare const calibration: typeof import('./page.ts');

/** The module of the pages that this runs in. */
export const CALIBRATION_PAGE = { entry: 'test/bench/calibration/page.ts', name: 'calibration' } as const;

export interface CalibrationPlan {
  readonly stages: readonly Stage[];
  /** Whether the scenes of the truth are drawn as well. */
  readonly truth: boolean;
}

export const THOROUGH_CALIBRATION: CalibrationPlan = {
  stages: [
    { samples: 16, seeds: 12 },
    { samples: 64, seeds: 8 },
    { samples: 256, seeds: 4 },
  ],
  truth: true,
};
export const QUICK_CALIBRATION: CalibrationPlan = { stages: [{ samples: 16, seeds: 3 }], truth: false };

export interface Calibration {
  readonly scene: string;
  readonly integrator: 'path' | 'direct';
  readonly samples: number;
  /** True error. */
  readonly noise: number;
  /** Estimated over true error: the median of the pictures, and the smallest and the largest. */
  readonly ratio: number;
  readonly least: number;
  readonly most: number;
  readonly tailIndex: number;
  /** How many pixels hold the noise. */
  readonly pixels: number;
  /** Whether its variance is finite and not that of a few pixels, and the row counts. */
  readonly judged: boolean;
}

export const LEAST_RATIO = 0.8;
export const MOST_RATIO = 1.25;
/** Below it a distribution has no variance. */
const FINITE = 2;
/** With fewer degrees of freedom k, the standard deviation of an estimated error, 1 / √(2 k) of it, is more than the limit. */
export const LEAST_PIXELS = 1 / (2 * (1 - LEAST_RATIO) ** 2);
/** Nobody sees less, and rounding is noise as well. */
const LEAST_NOISE = 1e-4;

export async function measureCalibration(
  browser: BenchBrowser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
  { stages, truth }: CalibrationPlan,
): Promise<readonly Calibration[]> {
  const plan = stages.map(({ samples, seeds }) => `${samples} samples (${seeds} pictures)`);
  console.log(`\nestimated over true noise of pictures of 96 × 64 pixels at ${plan.join(', ')}`);
  const subjects = [...gallerySubjects(scenes), ...(truth ? await truthSubjects() : [])];
  const rows: Calibration[] = [];
  for (const one of subjects) rows.push(...(await measureSubject(browser, one, stages)));
  printFoot(rows);
  return rows;
}

export async function measureSubject(
  browser: BenchBrowser,
  { name, subject }: BenchSubject,
  stages: readonly Stage[],
): Promise<readonly Calibration[]> {
  const page = await browser.open();
  const known = await page.execute((task) => calibration.calibrate(task), { subject, stages });
  await page.close();
  const rows = rowsOf({ name, subject }, stages, known);
  printRows(rows);
  return rows;
}

function rowsOf(
  { name, subject: { integrator } }: BenchSubject,
  stages: readonly Stage[],
  known: ReturnType<typeof calibration.calibrate>,
): readonly Calibration[] {
  const rows = stages.map(({ samples }, i) => {
    const sorted = [...(known.ratios[i] as readonly number[])].sort((a, b) => a - b);
    return {
      scene: name,
      integrator,
      samples,
      noise: known.noise[i] as number,
      ratio: ((sorted[(sorted.length - 1) >> 1] as number) + (sorted[sorted.length >> 1] as number)) / 2,
      least: sorted[0] as number,
      most: sorted.at(-1) as number,
      tailIndex: known.tailIndex,
      pixels: known.pixels[i] as number,
      judged: known.tailIndex > FINITE && (known.pixels[i] as number) >= LEAST_PIXELS,
    };
  });
  return rows.filter(({ noise }) => noise > LEAST_NOISE);
}

export const hasVariance = ({ tailIndex }: Calibration): boolean => tailIndex > FINITE;

export const isRight = ({ ratio }: Calibration): boolean => ratio >= LEAST_RATIO && ratio <= MOST_RATIO;

function printRows(rows: readonly Calibration[]): void {
  const [first] = rows;
  if (!first) return;
  const { scene, integrator, tailIndex } = first;
  const ratios = rows.map((row) => `${row.ratio.toFixed(2)}${isRight(row) ? ' ' : '!'}`.padStart(7));
  const kind = hasVariance(first) ? '' : ', variance not finite';
  const pixels = rows.map((row) => row.pixels.toFixed(0)).join(' ');
  console.log(
    `${scene.padEnd(26)}${integrator.padEnd(8)}${ratios.join('')}   tail ${tailIndex.toFixed(1)}${kind}; pixels ${pixels}`,
  );
}

function printFoot(rows: readonly Calibration[]): void {
  const judged = rows.filter((row) => row.judged);
  const right = (some: readonly Calibration[]): string => `${some.filter(isRight).length} of ${some.length}`;
  console.log(
    `within ${LEAST_RATIO} to ${MOST_RATIO}: ${right(judged)} of finite variance in enough pixels, ${right(rows)} of all`,
  );
}
