/** What the GPU of a browser says to problems. */

import { type BenchBrowser, type BenchPage, startBrowser } from '../bench/browser-pages.ts';
import { findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import type { BrdfQuestion } from './brdf-tables.ts';
import type { BsdfQuestion } from './bsdf-tables.ts';
import type { GpuPicture } from './images/gpu-picture.ts';
import { withoutAlpha } from './images/reference-job.ts';
import type { Answer, Problem } from './problem.ts';
import type { Ask } from './vectors.ts';

/** So many at a time: no command may take a driver of browsers longer than it waits. */
const CHUNK = 200;
const MILLISECONDS = 5000;
/** In f32, more samples than these may change the last digits of their sum by more than pictures are judged to. */
const SAMPLES = 256;

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

  readonly ask: Ask = (problems) =>
    inChunks(problems, async (chunk) => {
      const texts = await this.page.execute((asked: readonly Problem[]) => truth.answer(asked), chunk);
      return texts.map((ways) => ways.map(parseAnswer));
    });

  readonly reflectance = (questions: readonly BrdfQuestion[]): Promise<readonly (readonly number[])[]> =>
    inChunks(questions, async (chunk) => {
      const texts = await this.page.execute((asked: readonly BrdfQuestion[]) => truth.reflectance(asked), chunk);
      return texts.map((channels) => channels.map(Number));
    });

  async show(picture: GpuPicture): Promise<void> {
    await this.page.execute((shown: GpuPicture) => truth.showPicture(shown), picture);
  }

  /** The mean of so many samples of the picture shown, linear RGB, the top row first. */
  async samples(seed: number, samples: number): Promise<Float64Array> {
    let mean: Float64Array = new Float64Array(0);
    for (let done = 0, pass = 0; done < samples; pass++) {
      const count = Math.min(SAMPLES, samples - done);
      const rgb = await this.#pass(seed * 2 ** 16 + pass, count);
      done += count;
      mean = pass === 0 ? rgb : mean.map((value, i) => value + ((rgb[i] as number) - value) * (count / done));
    }
    return mean;
  }

  async #pass(seed: number, samples: number): Promise<Float64Array> {
    await this.page.execute((settings) => truth.beginSamples(settings), { seed, samples });
    while (!(await this.page.execute((time: number) => truth.drawSamples(time), MILLISECONDS)));
    const bytes = Buffer.from(await this.page.execute(() => truth.readPicture(), undefined), 'base64');
    return withoutAlpha(new Float32Array(new Uint8Array(bytes).buffer));
  }

  readonly scattering = (questions: readonly BsdfQuestion[]): Promise<readonly (readonly number[])[]> =>
    inChunks(questions, async (chunk) => {
      const texts = await this.page.execute((asked: readonly BsdfQuestion[]) => truth.scattering(asked), chunk);
      return texts.map((channels) => channels.map(Number));
    });

  close(): Promise<void> {
    return this.#browser.close();
  }
}

async function inChunks<A, R>(all: readonly A[], ask: (chunk: readonly A[]) => Promise<readonly R[]>): Promise<R[]> {
  const answers: R[] = [];
  for (let i = 0; i < all.length; i += CHUNK) answers.push(...(await ask(all.slice(i, i + CHUNK))));
  return answers;
}

function parseAnswer(texts: readonly string[]): Answer {
  const [t, x, y, z] = texts.map(Number) as [number, number, number, number];
  return { t, normal: [x, y, z] };
}
