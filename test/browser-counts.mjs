// A web-test-runner reporter that counts the tests of each engine.
import { relative } from 'node:path';
import { failureLine, noTests, reportCounts } from './counts.mjs';

function countTests({ suites, tests }, counts, failures) {
  for (const { name, skipped, passed, error } of tests) {
    counts[skipped ? 'skipped' : passed ? 'passed' : 'failed']++;
    if (!skipped && !passed) failures.push(failureLine(name, error?.message));
  }
  for (const suite of suites) countTests(suite, counts, failures);
}

/** A page that ran no test, or failed outside of its tests, is one failure. */
function countPage({ testFile, testResults, passed, errors = [] }, counts, failures) {
  const before = { ...counts };
  const failed = [];
  if (testResults) countTests(testResults, counts, failed);
  const empty = Object.keys(counts).every((key) => counts[key] === before[key]);
  if (empty || (!passed && failed.length === 0)) {
    counts.failed++;
    failed.push(failureLine('the page', errors[0]?.message ?? 'no test ran'));
  }
  failures.push(...failed.map((line) => `${relative('.', testFile)}: ${line}`));
}

export function browserCounts() {
  /** @type {string[]} */
  let engines = [];
  return {
    start({ browserNames }) {
      engines = browserNames;
    },
    stop({ sessions }) {
      for (const engine of engines) {
        const counts = noTests();
        const failures = [];
        for (const session of sessions) if (session.browser.name === engine) countPage(session, counts, failures);
        const group = `browser ${engine.toLowerCase()}`;
        reportCounts(group, counts, failures);
        console.log(`${group}: ${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
      }
    },
  };
}
