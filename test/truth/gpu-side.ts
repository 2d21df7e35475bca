/** What the GPU of a browser says to problems. */

import { type BenchBrowser, type BenchPage, startBrowser } from '../bench/browser-pages.ts';
import { findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import type { Answer, Problem } from './problem.ts';
import type { Ask } from './vectors.ts';

/** So many at a time: no command may take a driver of browsers longer than it waits. */
const CHUNK = 200;

/** In the page: what page.ts exports. */
declare const truth: typeof import('./page.ts');

export class Gpu {
  readonly #browser: BenchBrowser;
  readonly page: BenchPage;

  private constructor(browser: BenchBrowser, page: BenchPage) {
    this.#browser = browser;
    this.page = page;
  }

  static async start(engine: string): Promise<Gpu> {
    const browser = await findBrowser(engine);
    if (!browser) throw new Error(`there is no browser for ${engine}`);
    await ensureDisplay([browser]);
    const started = await startBrowser(browser, { entry: 'test/truth/page.ts', name: 'truth' });
    return new Gpu(started, await started.open());
  }

  readonly ask: Ask = async (problems) => {
    const answers: (readonly Answer[])[] = [];
    for (let i = 0; i < problems.length; i += CHUNK) {
      const chunk = problems.slice(i, i + CHUNK) as Problem[];
      const texts = await this.page.execute((asked: Problem[]) => truth.answer(asked), chunk);
      answers.push(...texts.map((ways) => ways.map(parseAnswer)));
    }
    return answers;
  };

  close(): Promise<void> {
    return this.#browser.close();
  }
}

function parseAnswer(texts: readonly string[]): Answer {
  const [t, x, y, z] = texts.map(Number) as [number, number, number, number];
  return { t, normal: [x, y, z] };
}
