/** What the numbers of the bench belong to. */
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { arch, availableParallelism, cpus, loadavg, release, type } from 'node:os';
import { brotliCompressSync } from 'node:zlib';
import type { BenchBrowser } from './browser-pages.ts';
import { childrenCpuMs } from './cpu-time.ts';

declare const bench: typeof import('./page.ts');

const BUNDLE = 'packages/ray-scene/dist/ray-scene.min.js';

/** The size of the one file that a page loads, as it was last built; null where it does not build. */
export function bundleSize(): number | null {
  if (!existsSync(BUNDLE)) spawnSync('npm', ['run', '--silent', 'build'], { shell: process.platform === 'win32' });
  return existsSync(BUNDLE) ? brotliCompressSync(readFileSync(BUNDLE)).length : null;
}

export interface Machine {
  readonly processor: string;
  readonly cores: number;
  readonly system: string;
  /** Processes that wanted to run, on average over the minute before. */
  readonly load: number;
  readonly browser: string;
  readonly renderer: string;
  /** What times of samples are: of all processors together, or of the clock on the wall. */
  readonly sampleTimes: 'cpu' | 'wall';
}

export async function describeMachine(start: () => Promise<BenchBrowser>): Promise<Machine> {
  const browser = await start();
  const page = await browser.open();
  const renderer = await page.execute(() => bench.rendererName(), undefined);
  await browser.close();
  return {
    processor: cpus()[0]?.model ?? 'unknown',
    cores: availableParallelism(),
    system: `${type()} ${release()} ${arch()}`,
    load: loadavg()[0] as number,
    browser: browser.version,
    renderer,
    sampleTimes: childrenCpuMs() === undefined ? 'wall' : 'cpu',
  };
}
