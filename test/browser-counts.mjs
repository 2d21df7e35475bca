// A web-test-runner reporter that counts the tests of each engine.
import { noTests, reportCounts } from './counts.mjs';

function countTests({ suites, tests }, counts) {
  for (const { skipped, passed } of tests) counts[skipped ? 'skipped' : passed ? 'passed' : 'failed']++;
  for (const suite of suites) countTests(suite, counts);
}

/** A page that ran no test, or failed outside of its tests, is one failure. */
function countPage({ testFile, testResults, passed }, counts) {
  const before = { ...counts };
  if (testResults) countTests(testResults, counts);
  const empty = Object.keys(counts).every((key) => counts[key] === before[key]);
  if (empty && passed) console.error(`No test ran in ${testFile}`);
  if (empty || (!passed && counts.failed === before.failed)) counts.failed++;
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
        for (const session of sessions) if (session.browser.name === engine) countPage(session, counts);
        const group = `browser ${engine.toLowerCase()}`;
        reportCounts(group, counts);
        console.log(`${group}: ${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
      }
    },
  };
}
