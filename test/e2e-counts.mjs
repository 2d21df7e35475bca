// A Playwright reporter that counts the tests of each engine.
import { noTests, reportCounts } from './counts.mjs';

const KEYS = { expected: 'passed', unexpected: 'failed', flaky: 'failed', skipped: 'skipped' };

export default class EndToEndCounts {
  onBegin(_config, suite) {
    this.suite = suite;
  }

  onEnd() {
    for (const project of this.suite?.suites ?? []) {
      const counts = noTests();
      for (const test of project.allTests()) counts[KEYS[test.outcome()]]++;
      const group = `e2e ${project.title}`;
      reportCounts(group, counts);
      console.log(`${group}: ${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
    }
  }
}
