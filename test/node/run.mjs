// Runs test files under node:test: node --import ./test/node/register.mjs test/node/run.mjs [--group NAME] PATH...
// A PATH is a test file or a folder of *.test.ts files. Prints what failed and what tests wrote, nothing else.
import { readdirSync, statSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { run } from 'node:test';
import { inspect, parseArgs } from 'node:util';
import { failureLine, noTests, reportCounts } from '../counts.mjs';

const { values, positionals } = parseArgs({
  options: { group: { type: 'string', default: 'unit' } },
  allowPositionals: true,
});

function testFiles(path) {
  if (statSync(path).isFile()) return [resolve(path)];
  const names = readdirSync(path, { recursive: true }).filter((name) => name.endsWith('.test.ts'));
  return names.sort().map((name) => resolve(join(path, name)));
}

const failures = [];

function fail(counts, { name, file }, why) {
  counts.failed++;
  failures.push(failureLine(`${relative('.', file)}, ${name}`, why));
  console.error(`\n✖ ${name === file ? '' : `${name}, `}${relative('.', file)}\n${why}`);
}

function onFailure(counts, data) {
  const { failureType, cause } = data.details.error;
  // A suite or a parent fails with its children, which were counted already.
  if (failureType === 'subtestsFailed') return;
  if (data.todo !== undefined) counts.skipped++;
  else fail(counts, data, cause instanceof Error ? inspect(cause) : String(cause));
}

function onPass(counts, data) {
  // node:test reports a file that ended without running any test as one passed test with the file's name.
  if (data.name === data.file) fail(counts, data, 'No test ran in this file.');
  else if (data.details.type === 'suite') return;
  else if (data.skip !== undefined || data.todo !== undefined) counts.skipped++;
  else counts.passed++;
}

// The runner's own totals, which come as diagnostics, count suites' files and cancelled tests in ways of their own.
const isTotal = (message) => /^(tests|suites|pass|fail|cancelled|skipped|todo|duration_ms) [\d.]+$/.test(message);

const counts = noTests();
for await (const { type, data } of run({ files: positionals.flatMap(testFiles), concurrency: true })) {
  if (type === 'test:fail') onFailure(counts, data);
  else if (type === 'test:pass') onPass(counts, data);
  else if (type === 'test:stdout') process.stdout.write(data.message);
  else if (type === 'test:stderr') process.stderr.write(data.message);
  else if (type === 'test:diagnostic' && !isTotal(data.message)) console.log(data.message);
}

reportCounts(values.group, counts, failures);
console.log(`${values.group}: ${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
if (counts.failed > 0 || counts.passed === 0) process.exitCode = 1;
