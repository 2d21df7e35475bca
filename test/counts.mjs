// How the test runners tell test/run.mjs what they executed: one JSON line per group, appended to a file that it names.
import { appendFileSync } from 'node:fs';

/** An empty count, for the runners to fill. */
export const noTests = () => ({ passed: 0, failed: 0, skipped: 0 });

/**
 * @param {string} group what the numbers belong to, as "unit" or "browser firefox"
 * @param {{ passed: number, failed: number, skipped: number }} counts
 * @param {string[]} failures what failed, and the first line of why
 */
export function reportCounts(group, { passed, failed, skipped }, failures = []) {
  const file = process.env.RAY_SCENE_COUNTS;
  if (file) appendFileSync(file, `${JSON.stringify({ group, passed, failed, skipped, failures })}\n`);
}

/** One line about a failed test. */
export const failureLine = (name, why) => `${name}: ${String(why).trim().split('\n', 1)[0]}`;
