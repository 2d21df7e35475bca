// npm test: installs what is missing, then checks, builds and runs every test. --full allows the tests long runs.
// The last line counts the tests. What fails without a failed test, or should have run tests and did not, counts as one.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { installPackages } from '../examples/serve.mjs';
import { wantedEngines } from './browsers.mjs';
import { installBrowsers } from './install-browsers.mjs';

const full = process.argv.includes('--full');
if (full) process.env.RAY_SCENE_FULL = '1';

/** @type {{ name: string, seconds?: number, passed: number, failed: number, skipped: number, failures?: string[] }[]} */
const rows = [];

/** What the runners reported to counts.mjs, and a failure for each group that is missing or empty. */
function readCounts(file, groups) {
  const lines = existsSync(file) ? readFileSync(file, 'utf8').trimEnd().split('\n') : [];
  const counts = lines.map((line) => JSON.parse(line));
  const ran = (group) => counts.some((count) => count.group === group && count.passed + count.failed > 0);
  return [
    ...counts.map(({ group, ...numbers }) => ({ name: group, ...numbers })),
    ...groups.filter((group) => !ran(group)).map((group) => failure(`${group}: no test ran`)),
  ];
}

const failure = (name) => ({ name, passed: 0, failed: 1, skipped: 0 });

/** Runs a script of package.json that is expected to run tests of these groups. */
function step(script, groups = []) {
  console.log(`\n> npm run ${script}`);
  const folder = mkdtempSync(join(tmpdir(), 'ray-scene-'));
  const file = join(folder, 'counts');
  const env = { ...process.env, RAY_SCENE_COUNTS: file };
  const start = performance.now();
  const { status } = spawnSync('npm', ['run', '--silent', script], {
    stdio: 'inherit',
    env,
    shell: process.platform === 'win32',
  });
  const seconds = (performance.now() - start) / 1000;
  const counts = readCounts(file, groups);
  rmSync(folder, { recursive: true });
  if (status !== 0 && counts.every(({ failed }) => failed === 0)) counts.push(failure(`${script} failed`));
  rows.push({ name: script, seconds, passed: 0, failed: 0, skipped: 0 }, ...counts);
  return status === 0;
}

async function browserSteps(built) {
  console.log('\n> browsers');
  const missing = await installBrowsers();
  for (const engine of missing) {
    console.error(`\n!!!! NO BROWSER FOR ${engine.toUpperCase()}: ITS TESTS DO NOT RUN !!!!\n`);
    if (process.env.CI) rows.push(failure(`${engine}: no browser`));
  }
  const engines = wantedEngines().filter((engine) => !missing.includes(engine));
  const groups = (kind) => engines.map((engine) => `${kind} ${engine}`);
  step('test:browser', groups('browser'));
  if (built) step('test:e2e', groups('e2e'));
  else rows.push(failure('test:e2e: nothing built'));
}

function printTable() {
  console.log(`\n${'step'.padEnd(32)}${['seconds', 'passed', 'failed', 'skipped'].map((s) => s.padStart(9)).join('')}`);
  for (const { name, seconds, ...counts } of rows) {
    const numbers = seconds === undefined ? ['', counts.passed, counts.failed, counts.skipped] : [seconds.toFixed(1)];
    const indent = seconds === undefined ? '  ' : '';
    console.log((indent + name).padEnd(32) + numbers.map((n) => String(n).padStart(9)).join(''));
  }
}

/** At the very end, where the last lines of a long log have it. */
function printFailures() {
  for (const { name, failed, failures = [] } of rows) {
    if (failed > 0 && failures.length === 0) console.log(`✖ ${name}`);
    for (const line of failures) console.log(`✖ ${name}: ${line}`);
  }
}

installPackages();
step('check');
step('test:unit', ['unit']);
await browserSteps(step('build'));
if (full) step('test:truth', ['truth images']);
printTable();

const total = (key) => rows.reduce((sum, row) => sum + row[key], 0);
const [passed, failed] = [total('passed'), total('failed')];
process.exitCode = failed > 0 || passed === 0 ? 1 : 0;
console.log();
printFailures();
console.log(`${passed} passed, ${failed} failed`);
