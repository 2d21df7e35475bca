/** Goes through scenes and settings: what each costs, and how far from right it is. */
import type { BenchBrowser, BenchPage } from '../browser-pages.ts';
import { childrenCpuMs } from '../cpu-time.ts';
import { type Knob, QUICK_VARIANTS, type Setting, VARIANTS, type Variant } from './knobs.ts';
import type { Accuracy } from './page.ts';
import { typical } from './statistics.ts';

declare const trade: typeof import('./page.ts');

/** The module of the pages that this runs in. */
export const TRADE_PAGE = { entry: 'test/bench/trade/page.ts', name: 'trade' } as const;

export interface TradePlan {
  readonly variants: readonly Variant[];
  /** For the picture that all others are held to. */
  readonly convergeMs: number;
  /** For each setting, but at least two pictures. */
  readonly settingMs: number;
  readonly turns: number;
  readonly turnMs: number;
  /** Samples beyond which nothing is measured. */
  readonly mostSamples: number;
}

export const THOROUGH_TRADE: TradePlan = {
  variants: VARIANTS,
  convergeMs: 8000,
  settingMs: 700,
  turns: 5,
  turnMs: 50,
  mostSamples: 256,
};

export const QUICK_TRADE: TradePlan = {
  variants: QUICK_VARIANTS,
  convergeMs: 500,
  settingMs: 300,
  turns: 3,
  turnMs: 30,
  mostSamples: 16,
};

export interface Measured extends Accuracy {
  readonly name: string;
  readonly knob: Knob | 'none';
  readonly setting: Setting;
  readonly shaderChars: number;
  /** Once each: what a browser costs the first time has been paid by then. */
  readonly compileMs: number;
  readonly firstFrameMs: number;
  /** Of processors where the system tells, else of the clock; median, and mean distance of the middle half from it. */
  readonly msPerSample: number;
  readonly msSpread: number;
  /** The same of a frame in which one sample is drawn and the picture is shown. */
  readonly msPerFrame: number;
  readonly msPerFrameSpread: number;
}

export interface SceneTrade {
  /** Samples of the picture that all others are held to, and its noise. */
  readonly converged: { readonly samples: number; readonly noise: number };
  readonly settings: readonly Measured[];
}

export type Trade = { readonly [scene: string]: SceneTrade };

export async function measureTrade(
  browser: BenchBrowser,
  scenes: readonly { readonly name: string; readonly scene: string }[],
  plan: TradePlan,
  done: (name: string, scene: SceneTrade) => void,
): Promise<Trade> {
  const trade: { [scene: string]: SceneTrade } = {};
  for (const { name, scene } of scenes) {
    const page = await browser.open();
    const measured = await measureScene(page, scene, plan);
    await page.close();
    trade[name] = measured;
    done(name, measured);
  }
  return trade;
}

async function measureScene(page: BenchPage, scene: string, plan: TradePlan): Promise<SceneTrade> {
  const converged = await page.execute((task) => trade.converge(task), { scene, milliseconds: plan.convergeMs });
  const settings: Measured[] = [];
  for (const variant of plan.variants) settings.push(await measureVariant(page, variant, plan));
  return { converged, settings };
}

async function measureVariant(page: BenchPage, variant: Variant, plan: TradePlan): Promise<Measured> {
  const { name, knob, setting } = variant;
  const opened = await page.execute((one) => trade.open(one), setting);
  const wall = await page.execute(() => trade.run(2) / 2, undefined);
  const samples = Math.max(1, Math.ceil(plan.turnMs / wall));
  const turns = { sample: [] as number[], frame: [] as number[] };
  for (let turn = 0; turn < plan.turns; turn++) {
    turns.sample.push(await takeTurn(page, samples, false));
    turns.frame.push(await takeTurn(page, samples, true));
  }
  const [ofSample, ofFrame] = [typical(turns.sample), typical(turns.frame)];
  const accuracy = await page.execute((task) => trade.measure(task), {
    samples: variant.samples.filter((count) => count <= plan.mostSamples),
    leastSeeds: 2,
    mostSeeds: 16,
    milliseconds: plan.settingMs,
  });
  return {
    name,
    knob,
    setting,
    ...opened,
    msPerSample: ofSample.median,
    msSpread: ofSample.spread,
    msPerFrame: ofFrame.median,
    msPerFrameSpread: ofFrame.spread,
    ...accuracy,
  };
}

/** Milliseconds for a sample, or for a frame that shows it. */
async function takeTurn(page: BenchPage, samples: number, shows: boolean): Promise<number> {
  const before = childrenCpuMs();
  const wall = shows
    ? await page.execute((count) => trade.runFrames(count), samples)
    : await page.execute((count) => trade.run(count), samples);
  const after = childrenCpuMs();
  return (before === undefined || after === undefined ? wall : after - before) / samples;
}
