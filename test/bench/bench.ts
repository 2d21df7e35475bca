/**
 * `npm run bench -- [--quick] [--scene NAME] [--engine chromium|firefox|webkit] [--json FILE]`: how long it takes to the
 * first picture of each example scene, and for each further sample; and the same for shaders of the same scenes that
 * were written by hand (`floors/NAME.frag`). With `--primitives` instead: a sample of shapes of each kind, by the engine's
 * formulas and by those of textbooks. With `--convergence`: how fast the noise of paths goes down.
 */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { parse } from 'node:path';
import { parseArgs } from 'node:util';
import { parseSettings, type RenderSettings } from '@ray-scene/core';
import { type Browser, ENGINES, findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import { Gpu } from '../truth/gpu-side.ts';
import { startBrowser } from './browser-pages.ts';
import { bundleSize, describeMachine } from './circumstances.ts';
import { type Convergence, measureConvergence, printConvergence } from './convergence.ts';
import { measure, type Plan, type SceneToBench } from './measure.ts';
import { measurePrimitives, PRIMITIVES_PAGE, printPrimitives } from './primitives.ts';
import { printReport } from './report.ts';

const SCENES = 'examples/scenes';

/** The page of the classic asks for what the program that it is compared with does. */
const SETTINGS: { readonly [scene: string]: Partial<RenderSettings> } = {
  classic: { integrator: 'direct', bounces: 10 },
};

const QUICK: Plan = { coldStarts: 3, rounds: 9, turnMs: 200 };
const THOROUGH: Plan = { coldStarts: 9, rounds: 31, turnMs: 400 };

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    scene: { type: 'string' },
    engine: { type: 'string', default: 'chromium' },
    json: { type: 'string' },
    primitives: { type: 'boolean', default: false },
    convergence: { type: 'boolean', default: false },
  },
});

function oneOf(option: string, value: string, allowed: readonly string[]): string {
  if (!allowed.includes(value)) throw new Error(`--${option} takes ${allowed.join(', ')}, not ${value}`);
  return value;
}

function scenesToBench(): readonly SceneToBench[] {
  const all = readdirSync(SCENES).map((file) => parse(file).name);
  const names = options.scene === undefined ? all : [oneOf('scene', options.scene, all)];
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

async function wantedBrowser(): Promise<Browser> {
  const engine = oneOf('engine', options.engine, ENGINES);
  const browser = await findBrowser(engine);
  if (!browser) throw new Error(`there is no browser for ${engine}`);
  await ensureDisplay([browser]);
  return browser;
}

async function benchScenes(browser: Browser, plan: Plan) {
  const scenes = scenesToBench();
  const start = () => startBrowser(browser);
  const result = {
    machine: await describeMachine(start),
    plan,
    bundle: { brotli: bundleSize() },
    scenes: await measure(start, scenes, plan),
  };
  printReport(result);
  return result;
}

async function benchPrimitives(browser: Browser, plan: Plan) {
  const machine = await describeMachine(() => startBrowser(browser));
  const started = await startBrowser(browser, PRIMITIVES_PAGE);
  const primitives = await measurePrimitives(started, plan);
  await started.close();
  console.log(`${machine.browser}, ${machine.renderer}, load ${machine.load.toFixed(1)}`);
  printPrimitives(primitives);
  return { machine, plan, primitives };
}

async function benchConvergence(browser: Browser) {
  const machine = await describeMachine(() => startBrowser(browser));
  const gpu = await Gpu.start(browser.engine);
  const convergence: { [scene: string]: Convergence } = {};
  for (const { name, scene } of scenesToBench()) convergence[name] = await measureConvergence(gpu, scene);
  await gpu.close();
  printConvergence(convergence);
  return { machine, convergence };
}

const browser = await wantedBrowser();
const plan = options.quick ? QUICK : THOROUGH;
const part = options.primitives ? benchPrimitives : options.convergence ? benchConvergence : benchScenes;
const result = await part(browser, plan);
if (options.json) writeFileSync(options.json, `${JSON.stringify(result, null, 2)}\n`);
