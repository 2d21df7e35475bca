/** `npm run bench`: see `options.ts` for what it can be asked for. */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { parse } from 'node:path';
import { parseSettings, type RenderSettings } from '@ray-scene/core';
import { type Browser, findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import { Gpu } from '../truth/gpu-side.ts';
import { startBrowser } from './browser-pages.ts';
import { bundleSize, describeMachine } from './circumstances.ts';
import { type Convergence, measureConvergence, printConvergence, printConvergenceHead } from './convergence.ts';
import { measureFeatures, printFeature, printFeaturesHead } from './features.ts';
import { FRAMES_PAGE, measureFrames } from './frames.ts';
import { GOVERNED_PAGE, measureGoverned, printGovernedFoot, printGovernedHead } from './governed.ts';
import { measure, type Plan, type SceneToBench } from './measure.ts';
import { type BenchOptions, oneOf, readOptions, USAGE } from './options.ts';
import { measurePrimitives, PRIMITIVES_PAGE, printPrimitives } from './primitives.ts';
import { printMachine, printScenes } from './report.ts';
import { presetsOf, printPresets } from './trade/presets.ts';
import { benchTrade, printCalibration, readNumbers, writeReport } from './trade/trade.ts';

const SCENES = 'examples/scenes';

/** The page of the classic asks for what the program that it is compared with does. */
const SETTINGS: { readonly [scene: string]: Partial<RenderSettings> } = {
  classic: { integrator: 'direct', bounces: 10 },
};

const QUICK: Plan = { coldStarts: 2, rounds: 9, turnMs: 100 };
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

async function benchAdaptive(browser: Browser, scenes: readonly SceneToBench[], { maxError, samples }: BenchOptions) {
  const started = await startBrowser(browser, GOVERNED_PAGE);
  printGovernedHead(maxError);
  const adaptive = await measureGoverned(started, scenes, maxError, samples);
  await started.close();
  printGovernedFoot(adaptive);
  return { maxError, adaptive };
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
  const result = {
    machine,
    plan,
    bundle,
    ...(parts.includes('primitives') && (await benchPrimitives(browser, plan))),
    ...(parts.includes('convergence') && (await benchConvergence(browser, scenes))),
    ...(parts.includes('features') && (await benchFeatures(browser, plan))),
    ...(parts.includes('adaptive') && (await benchAdaptive(browser, scenes, options))),
    ...(parts.includes('frames') && (await benchFrames(browser, scenes))),
    ...(parts.includes('scenes') && (await benchScenes(browser, scenes, plan))),
  };
  if (!parts.includes('trade')) return write(json, result);
  const numbers = await benchTrade(browser, scenes, quick);
  printCalibration(numbers.calibration);
  return write(json, { ...result, ...numbers });
}

function write<R>(file: string | undefined, result: R): R {
  if (file) writeFileSync(file, `${JSON.stringify(result, null, 2)}\n`);
  return result;
}

async function main(): Promise<void> {
  const options = readOptions(process.argv.slice(2));
  if (options.help) return console.log(USAGE);
  const numbers = options.from ? readNumbers(options.from) : await bench(options);
  if (!('trade' in numbers)) return;
  if (options.report) writeReport(numbers, numbers.machine);
  if (options.presets && !printPresets(presetsOf(numbers.trade))) process.exitCode = 1;
}

await main().catch((error: Error) => {
  console.error(error.message);
  process.exitCode = 1;
});
