// How the test runners tell test/run.mjs what they executed: one JSON line per group, appended to a file that it names.
import { appendFileSync } from 'node:fs';

/** An empty count, for the runners to fill. */
export const noTests = () => ({ passed: 0, failed: 0, skipped: 0 });

/** @param {string} group what the numbers belong to, as "unit" or "browser firefox" */
export function reportCounts(group, { passed, failed, skipped }) {
  const file = process.env.RAY_SCENE_COUNTS;
  if (file) appendFileSync(file, `${JSON.stringify({ group, passed, failed, skipped })}\n`);
}
