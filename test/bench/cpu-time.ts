/**
 * How much of the processors the browsers take that this process started. On machines that are shared, and where the
 * renderer is software, that says more than the time that passed.
 */
import { readdirSync, readFileSync } from 'node:fs';

/** In milliseconds, over all threads; undefined where the system does not tell. Linux does. */
export function childrenCpuMs(): number | undefined {
  if (!numbersIn('/proc').includes(process.pid)) return undefined;
  const descendants = new Set([process.pid]);
  // Children have higher numbers than their parents, but for the few whose numbers began anew.
  for (const pid of numbersIn('/proc')) if (descendants.has(parentOf(pid))) descendants.add(pid);
  descendants.delete(process.pid);
  return [...descendants].flatMap(threadsOf).reduce((sum, thread) => sum + threadCpuMs(thread), 0);
}

/** The names in a folder that are numbers, in order. */
const numbersIn = (folder: string): readonly number[] =>
  attempt([], () => readdirSync(folder))
    .map(Number)
    .filter(Number.isInteger)
    .sort((a, b) => a - b);

/** The command's name stands in parentheses and may hold anything; behind it are the state and the parent. */
const parentOf = (pid: number): number =>
  Number(
    attempt('', () => readFileSync(`/proc/${pid}/stat`, 'utf8'))
      .split(') ')
      .at(-1)
      ?.split(' ')[1],
  );

const threadsOf = (pid: number): readonly string[] =>
  numbersIn(`/proc/${pid}/task`).map((thread) => `/proc/${pid}/task/${thread}`);

/** The first number is for how long it ran, in nanoseconds. */
const threadCpuMs = (thread: string): number =>
  Number(attempt('', () => readFileSync(`${thread}/schedstat`, 'utf8')).split(' ')[0]) / 1e6;

/** Processes and threads may end while they are asked. */
function attempt<T>(otherwise: T, read: () => T): T {
  try {
    return read();
  } catch {
    return otherwise;
  }
}
