/** The trade of speed for accuracy, as `npm run bench` prints and writes it. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import type { Browser } from '../../browsers.mjs';
import { startBrowser } from '../browser-pages.ts';
import type { Calibration } from '../calibration/calibration.ts';
import type { Machine } from '../circumstances.ts';
import type { Governed } from '../governed.ts';
import { galleryChoices, sceneChoices } from './front.ts';
import { measureTrade, QUICK_TRADE, type SceneTrade, THOROUGH_TRADE, TRADE_PAGE, type Trade } from './measure.ts';
import { plotTrade } from './plots.ts';
import { presetsOf } from './presets.ts';
import { reportText } from './report.ts';
import { biasText } from './scene-section.ts';
import { percent } from './words.ts';

/** What reports are made from. */
export interface TradeNumbers {
  readonly machine: Machine;
  readonly trade: Trade;
  readonly calibration?: readonly Calibration[];
  readonly stopping?: readonly Governed[];
}

/** @param save takes what there is after every scene: all of them take more than half an hour. */
export async function benchTrade(
  browser: Browser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
  quick: boolean,
  save: (part: { readonly trade: Trade }) => void,
): Promise<void> {
  const started = await startBrowser(browser, TRADE_PAGE);
  await measureTrade(started, scenes, quick ? QUICK_TRADE : THOROUGH_TRADE, (name, trade) => {
    printScene(name, trade[name] as SceneTrade);
    save({ trade });
  });
  await started.close();
}

/** What several runs wrote, as if it were one: of what more than one measured, the last counts, scene by scene. */
export function readNumbers(files: readonly string[]): Partial<TradeNumbers> {
  const all: readonly Partial<TradeNumbers>[] = files.map((file) => JSON.parse(readFileSync(file, 'utf8')));
  const scenes = all.flatMap(({ trade = {} }) => Object.entries(trade));
  const trade = Object.fromEntries([...new Map(scenes)].sort(([one], [other]) => (one < other ? -1 : 1)));
  return Object.assign({}, ...all, scenes.length > 0 && { trade });
}

function printScene(name: string, { settings, converged }: SceneTrade): void {
  console.log(
    `\n${name}: held to ${converged.samples} samples with a noise of ${percent(converged.noise)}; ${settings[0]?.seeds} seeds`,
  );
  console.log(line(['', 'ms/sample', 'samples', 'noise', 'bias', 'PSNR', 'FLIP', 'first ms', 'compile']));
  for (const measured of settings) {
    const { name: setting, msPerSample, points, firstFrameMs, compileMs } = measured;
    const last = points.at(-1) as (typeof points)[number];
    const accuracy = [
      last.samples,
      percent(last.noise),
      biasText(measured),
      last.psnr.toFixed(1),
      last.flip.toFixed(3),
    ];
    console.log(line([setting, msPerSample.toFixed(2), ...accuracy, firstFrameMs.toFixed(0), compileMs.toFixed(0)]));
  }
}

const DOCS = 'docs';
const PLOTS = 'what-accuracy-costs';

/** Writes the report and its pictures. */
export function writeReport(numbers: TradeNumbers): void {
  const { trade } = numbers;
  const presets = presetsOf(trade);
  mkdirSync(`${DOCS}/${PLOTS}`, { recursive: true });
  const plotOf = (scene = 'all-scenes'): string => `${PLOTS}/${scene}.svg`;
  const write = (file: string, text: string): void => writeFileSync(`${DOCS}/${file}`, text);
  write(plotOf(), plotTrade(galleryChoices(trade), presets));
  for (const [name, scene] of Object.entries(trade)) write(plotOf(name), plotTrade(sceneChoices(scene)));
  write('what-accuracy-costs.md', reportText({ ...numbers, presets }, plotOf));
}

const line = ([name, ...numbers]: readonly (string | number)[]): string =>
  String(name).padEnd(34) + numbers.map((number) => String(number).padStart(10)).join('');
