/** Goes through scenes and settings: what each costs, and how far from right it is. */
import type { BenchBrowser, BenchPage } from '../browser-pages.ts';
import { type Knob, PAIRED, QUICK_VARIANTS, type Setting, VARIANTS, type Variant } from './knobs.ts';
import { measurePaces, type Pace, type PacePlan } from './pace.ts';
import type { Accuracy } from './page.ts';

declare const trade: typeof import('./page.ts');

/** The module of the pages that this runs in. */
export const TRADE_PAGE = { entry: 'test/bench/trade/page.ts', name: 'trade' } as const;

export interface TradePlan extends PacePlan {
  readonly variants: readonly Variant[];
  /** For the pictures that all others are held to. */
  readonly convergeMs: number;
  /** How many of these there are at least. */
  readonly runs: number;
  /** For the pictures with few samples of the first setting: all have as many. */
  readonly settingMs: number;
  /** For the pictures with many samples of one setting: what takes longer is not drawn. */
  readonly manyMs: number;
}

export const THOROUGH_TRADE: TradePlan = {
  variants: VARIANTS,
  convergeMs: 20_000,
  runs: 8,
  settingMs: 1500,
  manyMs: 10_000,
  rounds: 5,
  roundsMs: 20_000,
  turnMs: 30,
};

export const QUICK_TRADE: TradePlan = {
  variants: QUICK_VARIANTS,
  convergeMs: 400,
  runs: 4,
  settingMs: 300,
  manyMs: 0,
  rounds: 3,
  roundsMs: 0,
  turnMs: 30,
};

export interface Measured extends Accuracy, Pace {
  readonly name: string;
  readonly knob: Knob | 'none';
  readonly setting: Setting;
  readonly shaderChars: number;
  /** Once each: what a browser costs the first time has been paid by then. */
  readonly compileMs: number;
  readonly firstFrameMs: number;
}

export interface SceneTrade {
  /** Samples of the picture that all others are held to, how many pictures it is the mean of, and its noise. */
  readonly converged: { readonly samples: number; readonly runs: number; readonly noise: number };
  readonly settings: readonly Measured[];
}

export type Trade = { readonly [scene: string]: SceneTrade };

export async function measureTrade(
  browser: BenchBrowser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
  plan: TradePlan,
  done: (name: string, trade: Trade) => void,
): Promise<Trade> {
  const trade: { [scene: string]: SceneTrade } = {};
  for (const { name, scene } of scenes) {
    const page = await browser.open();
    trade[name] = await measureScene(page, scene, plan);
    await page.close();
    done(name, trade);
  }
  return trade;
}

async function measureScene(page: BenchPage, scene: string, plan: TradePlan): Promise<SceneTrade> {
  const { variants, settingMs, manyMs } = plan;
  await page.execute((task) => trade.begin(task), { scene });
  const opened: Awaited<ReturnType<typeof openSetting>>[] = [];
  for (const { setting } of variants) opened.push(await openSetting(page, setting));
  const paces = await measurePaces(page, variants.length, plan);
  const { pace, ...converged } = await converge(page, plan);
  const seeds = Math.min(Math.max(Math.floor(settingMs / (PAIRED * pace)), LEAST_SEEDS), MOST_SEEDS);
  const mostSamples = Math.max(manyMs / (LEAST_SEEDS * pace), PAIRED);
  const settings: Measured[] = [];
  for (const [index, { name, knob, setting, samples }] of variants.entries()) {
    const task = { index, samples: samples.filter((count) => count <= mostSamples), seeds };
    const accuracy = await page.execute((one) => trade.measure(one), task);
    const costs = { ...(opened[index] as (typeof opened)[number]), ...(paces[index] as Pace) };
    settings.push({ name, knob, setting, ...costs, ...accuracy });
  }
  return { converged, settings };
}

const openSetting = (page: BenchPage, setting: Setting) => page.execute((one) => trade.open(one), setting);

/** Of pictures whose spread is looked at. */
const LEAST_SEEDS = 2;
const MOST_SEEDS = 8;
/** Binary logarithm of the fewest samples of a converged picture. */
const LEAST_POWER = 3;

/** Of the time for converged pictures, what those by `direct` may take: they tell which pixels are rare, and no more. */
const DIRECT_SHARE = 1 / 8;

/** Draws what all settings are held to. */
async function converge(page: BenchPage, { convergeMs, runs }: TradePlan) {
  await convergeBy(page, 'direct', runs, convergeMs * DIRECT_SHARE);
  const converged = await convergeBy(page, 'path', runs, convergeMs * (1 - DIRECT_SHARE));
  const { noise } = await page.execute(() => trade.judgeBy(), undefined);
  return { ...converged, noise };
}

/** Until the time is up: pictures of 2^k samples, whose random numbers are the most even ones. */
async function convergeBy(page: BenchPage, integrator: Setting['integrator'], least: number, milliseconds: number) {
  const end = performance.now() + milliseconds;
  const pace = await page.execute((by) => trade.paceOf(by), integrator);
  const samples = 2 ** Math.max(Math.floor(Math.log2(milliseconds / (least * pace))), LEAST_POWER);
  let runs = 0;
  for (; runs < least || performance.now() < end; runs++) {
    await page.execute((task) => trade.converge(task), { integrator, samples });
  }
  return { pace, samples: runs * samples, runs };
}
