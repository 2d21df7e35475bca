// A Playwright reporter that counts the tests of each engine.
import { failureLine, noTests, reportCounts } from './counts.mjs';

const KEYS = { expected: 'passed', unexpected: 'failed', flaky: 'failed', skipped: 'skipped' };

export default class EndToEndCounts {
  onBegin(_config, suite) {
    this.suite = suite;
  }

  onEnd() {
    for (const project of this.suite?.suites ?? []) {
      const counts = noTests();
      const failures = [];
      for (const test of project.allTests()) {
        const key = KEYS[test.outcome()];
        counts[key]++;
        const why = test.results.find(({ error }) => error)?.error?.message;
        if (key === 'failed') failures.push(failureLine(test.titlePath().filter(Boolean).join(', '), why));
      }
      const group = `e2e ${project.title}`;
      reportCounts(group, counts, failures);
      console.log(`${group}: ${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
    }
  }
}
