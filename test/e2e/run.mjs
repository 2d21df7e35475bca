// Runs the end-to-end tests: Playwright's in the browsers that it drives, and those of WebKit over WebDriver under
// node:test where only the system's WebKit is there. The packages must be built. Arguments go to Playwright.
import { spawnSync } from 'node:child_process';
import { findBrowsers, needsWebDriver } from '../browsers.mjs';

const browsers = await findBrowsers();
const node = (...args) => spawnSync(process.execPath, args, { stdio: 'inherit' }).status === 0;

const runs = [];
if (browsers.some((browser) => !needsWebDriver(browser))) {
  runs.push(['node_modules/@playwright/test/cli.js', 'test', ...process.argv.slice(2)]);
}
if (browsers.some(needsWebDriver)) {
  const register = ['--import', './test/node/register.mjs'];
  runs.push([...register, 'test/node/run.mjs', '--group', 'e2e webkit', 'test/e2e']);
}

const passed = runs.map((args) => node(...args));
if (passed.includes(false) || passed.length === 0) process.exitCode = 1;
