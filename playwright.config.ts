// End-to-end tests on the built packages, in the browsers that Playwright can drive on this machine.
import { defineConfig } from '@playwright/test';
import { serve } from './examples/serve.mjs';
import { findBrowsers, launchOptions, needsWebDriver } from './test/browsers.mjs';
import { ensureDisplay } from './test/display.mjs';

const full = process.env.RAY_SCENE_FULL === '1';
const browsers = (await findBrowsers()).filter((browser) => !needsWebDriver(browser));

// Workers load this file too: they inherit the environment, and with it the first process's server and display.
if (!process.env.RAY_SCENE_URL) {
  await ensureDisplay(browsers);
  const { server, url } = await serve(0);
  server.unref();
  process.env.RAY_SCENE_URL = url;
}

export default defineConfig({
  testDir: 'test/e2e',
  testMatch: '*.spec.ts',
  workers: 1,
  timeout: full ? 600_000 : 60_000,
  // Against pages that hang: how fast this machine is, is not what is tested.
  expect: { timeout: 30_000 },
  forbidOnly: Boolean(process.env.CI),
  reporter: [['dot'], ['./test/e2e-counts.mjs']],
  use: { baseURL: process.env.RAY_SCENE_URL, viewport: { width: 640, height: 480 } },
  projects: browsers.map((browser) => ({
    name: browser.engine,
    use: {
      browserName: browser.engine,
      launchOptions: launchOptions(browser),
      // Playwright's fixture decides about windows by itself, whatever the launch options say.
      headless: launchOptions(browser).headless ?? true,
    },
  })),
});
