/** The trade of speed for accuracy, as `npm run bench` prints and writes it. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import type { Browser } from '../../browsers.mjs';
import { startBrowser } from '../browser-pages.ts';
import type { Machine } from '../circumstances.ts';
import { galleryChoices, sceneChoices } from './front.ts';
import {
  type Calibration,
  calibrationOf,
  measureTrade,
  QUICK_TRADE,
  type SceneTrade,
  THOROUGH_TRADE,
  TRADE_PAGE,
  type Trade,
} from './measure.ts';
import { plotTrade } from './plots.ts';
import { presetsOf } from './presets.ts';
import { reportText } from './report.ts';

export interface TradeNumbers {
  readonly trade: Trade;
  readonly calibration: readonly Calibration[];
}

export async function benchTrade(
  browser: Browser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
  quick: boolean,
): Promise<TradeNumbers> {
  const started = await startBrowser(browser, TRADE_PAGE);
  const trade = await measureTrade(started, scenes, quick ? QUICK_TRADE : THOROUGH_TRADE, printScene);
  await started.close();
  return { trade, calibration: calibrationOf(trade) };
}

export const readNumbers = (file: string): TradeNumbers & { readonly machine: Machine } =>
  JSON.parse(readFileSync(file, 'utf8'));

function printScene(name: string, { settings, converged }: SceneTrade): void {
  console.log(`\n${name}: held to ${converged.samples} samples with a noise of ${percent(converged.noise)}`);
  console.log(line(['', 'ms/sample', 'samples', 'noise', 'bias', 'PSNR', 'FLIP', 'first ms', 'compile']));
  for (const { name: setting, msPerSample, points, bias, firstFrameMs, compileMs } of settings) {
    const last = points.at(-1) as (typeof points)[number];
    const accuracy = [last.samples, percent(last.noise), percent(bias), last.psnr.toFixed(1), last.flip.toFixed(3)];
    console.log(line([setting, msPerSample.toFixed(2), ...accuracy, firstFrameMs.toFixed(0), compileMs.toFixed(0)]));
  }
}

export function printCalibration(calibration: readonly Calibration[]): void {
  const judged = calibration.filter((row) => row.judged);
  const ratios = judged.map(({ ratio }) => ratio);
  const [least, most] = [Math.min(...ratios).toFixed(2), Math.max(...ratios).toFixed(2)];
  console.log(`\nestimated over true noise: ${least} to ${most} in ${judged.length} cases`);
  for (const { scene, integrator, samples, ratio } of judged.filter((row) => row.ratio < 0.8 || row.ratio > 1.25)) {
    console.log(`  outside of 0.8 to 1.25: ${scene}, ${integrator}, ${samples} samples: ${ratio.toFixed(2)}`);
  }
  const others = new Set(calibration.filter((row) => !row.judged).map(({ scene }) => scene));
  if (others.size > 0) console.log(`  a few pixels decide, which do not count: ${[...others].join(', ')}`);
}

const DOCS = 'docs';
const PLOTS = 'what-accuracy-costs';

/** Writes the report and its pictures. */
export function writeReport({ trade, calibration }: TradeNumbers, machine: Machine): void {
  const presets = presetsOf(trade);
  mkdirSync(`${DOCS}/${PLOTS}`, { recursive: true });
  const plotOf = (scene = 'all-scenes'): string => `${PLOTS}/${scene}.svg`;
  const write = (file: string, text: string): void => writeFileSync(`${DOCS}/${file}`, text);
  write(plotOf(), plotTrade(galleryChoices(trade), presets));
  for (const [name, scene] of Object.entries(trade)) write(plotOf(name), plotTrade(sceneChoices(scene)));
  write('what-accuracy-costs.md', reportText({ machine, trade, calibration, presets }, plotOf));
}

const percent = (share: number): string => `${(100 * share).toFixed(1)} %`;

const line = ([name, ...numbers]: readonly (string | number)[]): string =>
  String(name).padEnd(34) + numbers.map((number) => String(number).padStart(10)).join('');
