/** How long the settings of a scene take, compared with each other. */
import type { BenchPage } from '../browser-pages.ts';
import { childrenCpuMs } from '../cpu-time.ts';
import type { Turn } from './page.ts';
import { typical } from './statistics.ts';

declare const trade: typeof import('./page.ts');

export interface PacePlan {
  /** Every setting has a turn in each of them: at least so many, at most twice as many as long as there is time. */
  readonly rounds: number;
  readonly roundsMs: number;
  /** At least, of each turn. */
  readonly turnMs: number;
}

export interface Pace {
  /** Of each round: time for a sample over that of the first setting before and after. */
  readonly timeRatios: readonly number[];
  /** Of processors where the system tells, else of the clock: the median of the first setting, times that of the ratios. */
  readonly msPerSample: number;
  /** Of the rounds: mean distance of the middle half from the median. */
  readonly msSpread: number;
  /** The same of a frame in which one sample is drawn and the picture is shown. */
  readonly msPerFrame: number;
  readonly msPerFrameSpread: number;
}

/**
 * All settings in turns, forwards and backwards, each between two turns of the first one: what grows or wanes with time favours
 * nobody, and what else the machine does at the time is in both parts of a ratio.
 * @param count of the settings that are open in the page.
 */
export async function measurePaces(page: BenchPage, count: number, plan: PacePlan): Promise<readonly Pace[]> {
  const turns: Turn[] = [];
  for (let index = 0; index < count; index++) {
    const pace = await page.execute((one) => trade.warmUp(one), { index });
    turns.push({ index, samples: Math.max(1, Math.ceil(plan.turnMs / pace)), shows: false });
  }
  const empty: number[] = [];
  for (let i = 0; i < EMPTY_TURNS; i++) empty.push(await turnMs(page, { index: 0, samples: 0, shows: false }));
  const timer: Timer = { page, emptyMs: typical(empty).median };
  const { base, samples, ratios } = await compare(timer, turns, plan);
  const frames: number[][] = turns.map(() => []);
  for (let round = 0; round < FRAME_ROUNDS; round++) {
    for (const turn of turns) frames[turn.index]?.push(await takeTurn(timer, { ...turn, shows: true }));
  }
  const milliseconds = typical(base).median;
  return frames.map((frame, index) => {
    const timeRatios = ratios[index] as readonly number[];
    return {
      timeRatios,
      msPerSample: milliseconds * typical(timeRatios).median,
      msSpread: typical(samples[index] as readonly number[]).spread,
      msPerFrame: typical(frame).median,
      msPerFrameSpread: typical(frame).spread,
    };
  });
}

/** Rounds in which each sample is shown. */
const FRAME_ROUNDS = 2;
const EMPTY_TURNS = 9;

/** What a turn takes in which nothing is drawn is not counted: it would be more of a sample where a turn has few. */
interface Timer {
  readonly page: BenchPage;
  readonly emptyMs: number;
}

/** Milliseconds for a sample, and what they are over those of the first setting. */
async function compare(timer: Timer, turns: readonly Turn[], { rounds, roundsMs }: PacePlan) {
  const end = performance.now() + roundsMs;
  const [first, ...others] = turns as [Turn, ...Turn[]];
  const base: number[] = [];
  const samples: number[][] = [base, ...others.map(() => [])];
  const ratios: number[][] = turns.map(() => []);
  for (let round = 0; round < rounds || (round < 2 * rounds && performance.now() < end); round++) {
    ratios[0]?.push(1);
    base.push(await takeTurn(timer, first));
    for (const turn of round % 2 === 0 ? others : [...others].reverse()) {
      const before = base.at(-1) as number;
      const time = await takeTurn(timer, turn);
      const after = await takeTurn(timer, first);
      base.push(after);
      samples[turn.index]?.push(time);
      ratios[turn.index]?.push((2 * time) / (before + after));
    }
  }
  return { base, samples, ratios };
}

/** Milliseconds for a sample, or for a frame that shows it. */
const takeTurn = async ({ page, emptyMs }: Timer, turn: Turn): Promise<number> =>
  ((await turnMs(page, turn)) - emptyMs) / turn.samples;

async function turnMs(page: BenchPage, turn: Turn): Promise<number> {
  const before = childrenCpuMs();
  const wall = await page.execute((one) => trade.run(one), turn);
  const after = childrenCpuMs();
  return before === undefined || after === undefined ? wall : after - before;
}
