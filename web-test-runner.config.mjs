// Browser tests: TypeScript sources, unbundled, in every engine that this machine has.
import { fileURLToPath } from 'node:url';
import { defaultReporter } from '@web/test-runner';
import { playwrightLauncher } from '@web/test-runner-playwright';
import { browserCounts } from './test/browser-counts.mjs';
import { findBrowsers, launchOptions, needsWebDriver } from './test/browsers.mjs';
import { ensureDisplay } from './test/display.mjs';
import { compileTypeScript, textModule } from './test/node/compile.mjs';
import { webkitLauncher } from './test/webkit-launcher.mjs';

const full = process.env.RAY_SCENE_FULL === '1';
// Long runs look at other scenes each time.
const seed = Number(process.env.RAY_SCENE_SEED ?? (full ? Date.now() % 2 ** 31 : 1));
const browsers = await findBrowsers();
await ensureDisplay(browsers);

const sources = {
  name: 'sources',
  resolveMimeType: ({ path }) => (/\.(ts|glsl)$/.test(path) ? 'js' : undefined),
  transform({ path, body }) {
    if (path.endsWith('.ts')) return compileTypeScript(body, path);
    return path.endsWith('.glsl') ? textModule(body) : undefined;
  },
};

export default {
  rootDir: fileURLToPath(new URL('.', import.meta.url)),
  files: ['test/{browser,extremes}/**/*.test.ts'],
  nodeResolve: { exportConditions: ['source'] },
  plugins: [sources],
  browsers: browsers.map((browser) =>
    needsWebDriver(browser)
      ? webkitLauncher(browser)
      : playwrightLauncher({ product: browser.engine, launchOptions: launchOptions(browser) }),
  ),
  // More pages at once gain nothing: the software renderers use every core.
  concurrentBrowsers: 3,
  concurrency: 1,
  browserStartTimeout: 60_000,
  testsStartTimeout: 60_000,
  // Against tests that hang. On few and busy cores, one that draws a large scene in WebKit takes half a minute.
  testsFinishTimeout: full ? 1_800_000 : 600_000,
  testFramework: { config: { timeout: full ? 600_000 : 120_000 } },
  // A page has no environment: tests read globalThis.RAY_SCENE_FULL and RAY_SCENE_SEED.
  testRunnerHtml: (framework) =>
    `<!doctype html><script>globalThis.RAY_SCENE_FULL = ${full}; globalThis.RAY_SCENE_SEED = ${seed};</script><script type="module" src="${framework}"></script>`,
  reporters: [defaultReporter({ reportTestResults: true, reportTestProgress: false }), browserCounts()],
};
