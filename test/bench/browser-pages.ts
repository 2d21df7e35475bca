/** Pages with a module of tests in them, in any of the engines. */
import { build } from 'esbuild';
import { chromium, firefox, webkit } from 'playwright';
import { type Browser, launchOptions, needsWebDriver } from '../browsers.mjs';
import { openWebKit } from '../webdriver.mjs';

/** A page of its own, in which what the module exports is under the module's name. */
export interface BenchPage {
  /** Runs a function of the page's world, which sees its argument and the module only. */
  execute<A, R>(script: (argument: A) => R | Promise<R>, argument: A): Promise<R>;
  close(): Promise<void>;
}

export interface BenchBrowser {
  readonly version: string;
  /** Closes the one before. */
  open(): Promise<BenchPage>;
  close(): Promise<void>;
}

/** What the pages hold: `name` there is what the file `entry` exports. */
interface PageModule {
  readonly entry: string;
  readonly name: string;
}

const BENCH: PageModule = { entry: 'test/bench/page.ts', name: 'bench' };

/** Starts a browser that remembers nothing of earlier runs: no profile, and no programs that a driver compiled. */
export async function startBrowser(browser: Browser, module: PageModule = BENCH): Promise<BenchBrowser> {
  // Mesa keeps compiled shaders in the user's home, for all programs of that user.
  process.env.MESA_SHADER_CACHE_DISABLE = process.env.MESA_GLSL_CACHE_DISABLE = 'true';
  const code = codes.get(module.name) ?? (await bundle(module));
  codes.set(module.name, code);
  return needsWebDriver(browser) ? startWebDriver(browser, code) : startPlaywright(browser, code);
}

const codes = new Map<string, string>();

async function bundle({ entry, name }: PageModule): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [entry],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: name,
    conditions: ['source'],
    loader: { '.glsl': 'text' },
  });
  return outputFiles[0]?.text as string;
}

/** In the page. */
function addScript(text: string): void {
  const script = document.createElement('script');
  script.textContent = text;
  document.head.append(script);
}

async function startPlaywright(browser: Browser, text: string): Promise<BenchBrowser> {
  const started = await { chromium, firefox, webkit }[browser.engine].launch(launchOptions(browser));
  return {
    version: started.version(),
    async open() {
      for (const context of started.contexts()) await context.close();
      const page = await started.newPage();
      await page.evaluate(addScript, text);
      const execute = page.evaluate.bind(page) as BenchPage['execute'];
      return { execute, close: () => page.close() };
    },
    close: () => started.close(),
  };
}

async function startWebDriver(browser: Browser, text: string): Promise<BenchBrowser> {
  const window = await openWebKit(browser);
  return {
    version: await window.execute(() => navigator.userAgent),
    async open() {
      await window.goto('about:blank');
      await window.execute(addScript, text);
      return { execute: (script, argument) => window.execute(script, argument), close: async () => {} };
    },
    close: () => window.close(),
  };
}
