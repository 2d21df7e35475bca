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
  /** For each setting, but at least two pictures; those whose estimates of noise are judged get more. */
  readonly settingMs: number;
  readonly judgedMs: number;
  readonly turns: number;
  readonly turnMs: number;
  /** Samples beyond which nothing is measured. */
  readonly mostSamples: number;
}

export const THOROUGH_TRADE: TradePlan = {
  variants: VARIANTS,
  convergeMs: 8000,
  settingMs: 700,
  judgedMs: 4000,
  turns: 5,
  turnMs: 50,
  mostSamples: 256,
};

export const QUICK_TRADE: TradePlan = {
  variants: QUICK_VARIANTS,
  convergeMs: 500,
  settingMs: 300,
  judgedMs: 300,
  turns: 3,
  turnMs: 30,
  mostSamples: 64,
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
}

export interface SceneTrade {
  /** Samples of the picture that all others are held to, and its noise. */
  readonly converged: { readonly samples: number; readonly noise: number };
  readonly settings: readonly Measured[];
}

export type Trade = { readonly [scene: string]: SceneTrade };

export interface Calibration {
  readonly scene: string;
  readonly integrator: 'path' | 'direct';
  readonly samples: number;
  /** Estimated over true error: the median of several pictures, and the smallest and the largest. */
  readonly ratio: number;
  readonly least: number;
  readonly most: number;
  /** What share of the variance is that of the noisiest half percent of the pixels. */
  readonly rareShare: number;
  /** Whether it counts: where those few pixels are most of the noise, chance decides what it is said to be. */
  readonly judged: boolean;
}

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
  for (const [i, variant] of plan.variants.entries()) settings.push(await measureVariant(page, variant, i < 2, plan));
  return { converged, settings };
}

async function measureVariant(page: BenchPage, variant: Variant, judged: boolean, plan: TradePlan): Promise<Measured> {
  const { name, knob, setting } = variant;
  const opened = await page.execute((one) => trade.open(one), setting);
  const wall = await page.execute(() => trade.run(2) / 2, undefined);
  const samples = Math.max(1, Math.ceil(plan.turnMs / wall));
  const turns: number[] = [];
  for (let turn = 0; turn < plan.turns; turn++) turns.push(await takeTurn(page, samples));
  const { median, spread } = typical(turns);
  const accuracy = await page.execute((task) => trade.measure(task), {
    samples: variant.samples.filter((count) => count <= plan.mostSamples),
    leastSeeds: 2,
    mostSeeds: 16,
    milliseconds: judged ? plan.judgedMs : plan.settingMs,
  });
  return { name, knob, setting, ...opened, msPerSample: median, msSpread: spread, ...accuracy };
}

async function takeTurn(page: BenchPage, samples: number): Promise<number> {
  const before = childrenCpuMs();
  const wall = await page.execute((count) => trade.run(count), samples);
  const after = childrenCpuMs();
  return (before === undefined || after === undefined ? wall : after - before) / samples;
}

/** From as many samples on an estimate of noise is judged: no picture ends by it before. */
const FEWEST_JUDGED = 16;

/** How right the estimates of noise are, wherever there is noise. */
export function calibrationOf(trade: Trade): readonly Calibration[] {
  return Object.entries(trade).flatMap(([scene, { settings }]) =>
    settings.slice(0, 2).flatMap(({ setting: { integrator }, points }) =>
      points
        .filter(({ samples, noiseOfAll }) => samples >= FEWEST_JUDGED && noiseOfAll > 0)
        .map(({ samples, noiseOfAll, rareShare, estimates }) => {
          const ratios = estimates.map((estimate) => estimate / noiseOfAll);
          const [least, most] = [Math.min(...ratios), Math.max(...ratios)];
          return {
            scene,
            integrator,
            samples,
            ratio: typical(ratios).median,
            least,
            most,
            rareShare,
            judged: rareShare < 0.5,
          };
        }),
    ),
  );
}
