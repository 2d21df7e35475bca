/** The measurements: cold starts in browsers that know nothing yet, then samples of pictures in turns. */

import type { PackedImage } from '../truth/images/packed-image.ts';
import type { BenchBrowser, BenchPage } from './browser-pages.ts';
import { childrenCpuMs } from './cpu-time.ts';
import type { Subject } from './page.ts';

declare const bench: typeof import('./page.ts');

/** Width and height of the pictures; floors are compared at the other size as well. */
const SIZE = 300;
const OTHER_SIZE = 600;

export interface SceneToBench {
  readonly name: string;
  /** JSON text. */
  readonly scene: string;
  readonly integrator: 'path' | 'direct';
  readonly bounces: number;
  readonly clamp?: number;
  readonly images?: readonly PackedImage[];
  /** Source of a shader that was written by hand for this scene. */
  readonly floor?: string;
}

export interface Plan {
  readonly coldStarts: number;
  /** Every picture has a turn in each of them. */
  readonly rounds: number;
  /** About how long a turn takes. */
  readonly turnMs: number;
}

/** Medians. */
export interface ColdStart {
  readonly compileMs: number;
  readonly firstFrameMs: number;
  readonly floorCompileMs?: number;
  readonly floorFirstFrameMs?: number;
}

/** Medians; the ratio is that of the rounds' ratios. */
export interface Pace {
  readonly msPerSample: number;
  readonly wallMsPerSample: number;
  readonly floorMsPerSample?: number;
  readonly floorWallMsPerSample?: number;
  readonly floorRatio?: number;
}

interface Samples extends Pace {
  readonly shaderChars: number;
  /** How far the pictures are apart, relative: the median of all pixels. */
  readonly floorDifference?: number;
  readonly at600?: Pace;
}

export interface Measured extends ColdStart, Samples {
  readonly integrator: 'path' | 'direct';
  readonly bounces: number;
}

export type Start = () => Promise<BenchBrowser>;

export async function measure(
  start: Start,
  scenes: readonly SceneToBench[],
  plan: Plan,
): Promise<{ readonly [scene: string]: Measured }> {
  const coldStarts = await measureColdStarts(start, scenes, plan);
  const browser = await start();
  const measured: { [scene: string]: Measured } = {};
  for (const [i, scene] of scenes.entries()) {
    const samples = await measureSamples(await browser.open(), scene, plan);
    measured[scene.name] = {
      integrator: scene.integrator,
      bounces: scene.bounces,
      ...(coldStarts[i] as ColdStart),
      ...samples,
    };
  }
  await browser.close();
  return measured;
}

/** A scene as the generated shader draws it and, if there is one, its floor. */
export function subjectsOf({ name, floor, ...scene }: SceneToBench, size = SIZE): readonly Subject[] {
  const subject = { ...scene, size };
  return floor ? [subject, { ...subject, floor }] : [subject];
}

/** Each scene and each floor starts in a page of its own, in turns, once in every browser. */
export async function measureColdStarts(
  start: Start,
  scenes: readonly SceneToBench[],
  plan: Plan,
): Promise<ColdStart[]> {
  const starts = scenes.map((scene) => subjectsOf(scene).map((subject) => ({ subject, times: [] as Times[] })));
  type Times = ReturnType<typeof bench.coldStart>;
  const turns = starts.flat();
  for (let i = 0; i < plan.coldStarts; i++) {
    const browser = await start();
    // Another one is first each time: it pays for what the browser does only once.
    for (const { subject, times } of [...turns.slice(i % turns.length), ...turns.slice(0, i % turns.length)]) {
      const page = await browser.open();
      times.push(await page.execute((one) => bench.coldStart(one), subject));
    }
    await browser.close();
  }
  return starts.map((ofScene) => {
    const [scene, floor] = ofScene.map(({ times }) => ({
      compileMs: median(times.map(({ compileMs }) => compileMs)),
      firstFrameMs: median(times.map(({ firstFrameMs }) => firstFrameMs)),
    }));
    return {
      ...(scene as ColdStart),
      ...(floor && { floorCompileMs: floor.compileMs, floorFirstFrameMs: floor.firstFrameMs }),
    };
  });
}

async function measureSamples(page: BenchPage, scene: SceneToBench, plan: Plan): Promise<Samples> {
  const { shaderChars } = await page.execute((subjects) => bench.prepare(subjects), subjectsOf(scene));
  if (!scene.floor) {
    // Medians of times by themselves depend on what else the machine does, and more rounds do not mend that.
    const rounds = Math.ceil(plan.rounds / 2);
    return { shaderChars, ...(await measurePace(page, subjectsOf(scene), { ...plan, rounds })) };
  }
  const pace = await measurePace(page, subjectsOf(scene), plan);
  const floorDifference = await page.execute(() => bench.difference(), undefined);
  const at600 = await measurePace(page, subjectsOf(scene, OTHER_SIZE), plan);
  return { shaderChars, ...pace, floorDifference, at600 };
}

/** One turn: milliseconds per sample. */
interface Turn {
  readonly cpu: number | undefined;
  readonly wall: number;
}

export async function measurePace(
  page: BenchPage,
  subjects: readonly Subject[],
  { rounds, turnMs }: Plan,
): Promise<Pace> {
  await page.execute((prepared) => bench.prepare(prepared), subjects);
  const indices = subjects.map((_, i) => i);
  for (const index of indices) await takeTurn(page, index, 1);
  const samples = Math.ceil(turnMs / (await takeTurn(page, 0, 2)).wall);
  const turns: Turn[][] = subjects.map(() => []);
  for (let round = 0; round < rounds; round++) {
    // Whoever went first goes last in the next round: what grows or wanes with time then favours nobody.
    for (const index of round % 2 === 0 ? indices : [...indices].reverse()) {
      turns[index]?.push(await takeTurn(page, index, samples));
    }
  }
  return paceOf(turns);
}

async function takeTurn(page: BenchPage, index: number, samples: number): Promise<Turn> {
  const before = childrenCpuMs();
  const wall = await page.execute((turn) => bench.run(turn.index, turn.samples), { index, samples });
  const after = childrenCpuMs();
  return {
    cpu: before === undefined || after === undefined ? undefined : (after - before) / samples,
    wall: wall / samples,
  };
}

function paceOf([scene = [], floor]: readonly (readonly Turn[])[]): Pace {
  const time = ({ cpu, wall }: Turn): number => cpu ?? wall;
  const typical = (turns: readonly Turn[]) => [median(turns.map(time)), median(turns.map(({ wall }) => wall))] as const;
  const [msPerSample, wallMsPerSample] = typical(scene);
  if (!floor) return { msPerSample, wallMsPerSample };
  const [floorMsPerSample, floorWallMsPerSample] = typical(floor);
  const floorRatio = median(scene.map((turn, i) => time(turn) / time(floor[i] as Turn)));
  return { msPerSample, wallMsPerSample, floorMsPerSample, floorWallMsPerSample, floorRatio };
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1
    ? (sorted[middle] as number)
    : ((sorted[middle - 1] as number) + (sorted[middle] as number)) / 2;
}
