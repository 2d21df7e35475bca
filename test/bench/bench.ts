/** `npm run bench`: see `options.ts` for what it can be asked for. */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { parse } from 'node:path';
import { parseSettings, type RenderSettings } from '@ray-scene/core';
import { type Browser, findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import { Gpu } from '../truth/gpu-side.ts';
import { startBrowser } from './browser-pages.ts';
import {
  CALIBRATION_PAGE,
  measureCalibration,
  QUICK_CALIBRATION,
  THOROUGH_CALIBRATION,
} from './calibration/calibration.ts';
import { bundleSize, describeMachine } from './circumstances.ts';
import { type Convergence, measureConvergence, printConvergence, printConvergenceHead } from './convergence.ts';
import { measureFeatures, printFeature, printFeaturesHead } from './features.ts';
import { FRAMES_PAGE, measureFrames } from './frames.ts';
import { GOVERNED_PAGE, measureGoverned } from './governed.ts';
import { measure, type Plan, type SceneToBench } from './measure.ts';
import { type BenchOptions, oneOf, readOptions, USAGE } from './options.ts';
import { measurePrimitives, PRIMITIVES_PAGE, printPrimitives } from './primitives.ts';
import { printMachine, printScenes } from './report.ts';
import { presetsOf, printPresets } from './trade/presets.ts';
import { benchTrade, readNumbers, type TradeNumbers, writeReport } from './trade/trade.ts';

const SCENES = 'examples/scenes';

/** The page of the classic asks for what the program that it is compared with does. */
const SETTINGS: { readonly [scene: string]: Partial<RenderSettings> } = {
  classic: { integrator: 'direct', bounces: 10 },
};

const QUICK: Plan = { coldStarts: 1, rounds: 5, turnMs: 100 };
const THOROUGH: Plan = { coldStarts: 9, rounds: 31, turnMs: 400 };

function scenesToBench(scene: string | undefined): readonly SceneToBench[] {
  const all = readdirSync(SCENES).map((file) => parse(file).name);
  const names = scene === undefined ? all : [oneOf('scene', scene, all)];
  return names.map((name) => {
    const floor = `test/bench/floors/${name}.frag`;
    return {
      name,
      scene: readFileSync(`${SCENES}/${name}.json`, 'utf8'),
      ...tracing(name),
      ...(existsSync(floor) ? { floor: readFileSync(floor, 'utf8') } : {}),
    };
  });
}

function tracing(name: string): Pick<RenderSettings, 'integrator' | 'bounces'> {
  const { integrator, bounces } = parseSettings(SETTINGS[name]);
  return { integrator, bounces };
}

async function wantedBrowser(engine: string): Promise<Browser> {
  const browser = await findBrowser(engine);
  if (!browser) throw new Error(`there is no browser for ${engine}`);
  await ensureDisplay([browser]);
  return browser;
}

async function benchPrimitives(browser: Browser, plan: Plan) {
  const started = await startBrowser(browser, PRIMITIVES_PAGE);
  const primitives = await measurePrimitives(started, plan);
  await started.close();
  printPrimitives(primitives);
  return { primitives };
}

async function benchConvergence(browser: Browser, scenes: readonly SceneToBench[]) {
  const gpu = await Gpu.start(browser.engine);
  const convergence: { [scene: string]: Convergence } = {};
  printConvergenceHead();
  for (const { name, scene } of scenes) {
    const measured = await measureConvergence(gpu, scene);
    convergence[name] = measured;
    printConvergence(name, measured);
  }
  await gpu.close();
  return { convergence };
}

async function benchFeatures(browser: Browser, plan: Plan) {
  printFeaturesHead(plan);
  return { features: await measureFeatures(() => startBrowser(browser), plan, printFeature) };
}

async function benchCalibration(browser: Browser, scenes: readonly SceneToBench[], { quick, scene }: BenchOptions) {
  const started = await startBrowser(browser, CALIBRATION_PAGE);
  const plan = quick ? QUICK_CALIBRATION : THOROUGH_CALIBRATION;
  const calibration = await measureCalibration(started, scenes, { ...plan, truth: plan.truth && scene === undefined });
  await started.close();
  return { calibration };
}

async function benchAdaptive(browser: Browser, scenes: readonly SceneToBench[], { maxErrors, samples }: BenchOptions) {
  const started = await startBrowser(browser, GOVERNED_PAGE);
  const stopping = await measureGoverned(started, scenes, maxErrors, samples);
  await started.close();
  return { stopping };
}

async function benchFrames(browser: Browser, scenes: readonly SceneToBench[]) {
  const started = await startBrowser(browser, FRAMES_PAGE);
  const frames = await measureFrames(started, scenes);
  await started.close();
  return { frames };
}

async function benchScenes(browser: Browser, scenes: readonly SceneToBench[], plan: Plan) {
  const result = { scenes: await measure(() => startBrowser(browser), scenes, plan) };
  printScenes(result.scenes, plan);
  return result;
}

async function bench(options: BenchOptions) {
  const { quick, parts, scene, engine, json } = options;
  const scenes = scenesToBench(scene);
  const browser = await wantedBrowser(engine);
  const plan = quick ? QUICK : THOROUGH;
  const machine = await describeMachine(() => startBrowser(browser));
  const bundle = { brotli: bundleSize() };
  printMachine(machine, bundle.brotli);
  const result = { machine, plan, bundle };
  // Whatever there is, so that an end that comes too soon loses nothing.
  const add = (part: object): void => {
    Object.assign(result, part);
    if (json) writeFileSync(json, `${JSON.stringify(result, null, 2)}\n`);
  };
  add({});
  if (parts.includes('primitives')) add(await benchPrimitives(browser, plan));
  if (parts.includes('convergence')) add(await benchConvergence(browser, scenes));
  if (parts.includes('features')) add(await benchFeatures(browser, plan));
  if (parts.includes('adaptive')) add(await benchAdaptive(browser, scenes, options));
  if (parts.includes('frames')) add(await benchFrames(browser, scenes));
  if (parts.includes('scenes')) add(await benchScenes(browser, scenes, plan));
  if (parts.includes('trade')) await benchTrade(browser, scenes, quick, add);
  if (parts.includes('calibration')) add(await benchCalibration(browser, scenes, options));
  return result;
}

async function main(): Promise<void> {
  const options = readOptions(process.argv.slice(2));
  if (options.help) return console.log(USAGE);
  const numbers: Partial<TradeNumbers> = options.from.length > 0 ? readNumbers(options.from) : await bench(options);
  if (!numbers.trade) return;
  if (options.report) writeReport(numbers as TradeNumbers);
  if (options.presets && !printPresets(presetsOf(numbers.trade))) process.exitCode = 1;
}

await main().catch((error: Error) => {
  console.error(error.message);
  process.exitCode = 1;
});
