/** The most important end-to-end tests, in the system's WebKit, which Playwright cannot drive. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { serve } from '../../examples/serve.mjs';
import { findBrowser } from '../browsers.mjs';
import { ensureDisplay } from '../display.mjs';
import { openWebKit } from '../webdriver.mjs';

let server: Awaited<ReturnType<typeof serve>>;
let browser: Awaited<ReturnType<typeof openWebKit>>;

before(async () => {
  const webkit = await findBrowser('webkit');
  assert.ok(webkit);
  await ensureDisplay([webkit]);
  server = await serve(0);
  browser = await openWebKit(webkit);
});

after(async () => {
  await browser?.close();
  server?.server.close();
});

/** How many colours each element of the page shows, and a number that changes with its picture. */
const pictures = (): Promise<{ colors: number; hash: number }[]> =>
  browser.execute(async () => {
    const shown: { colors: number; hash: number }[] = [];
    for (const element of document.querySelectorAll('ray-scene')) {
      element.scrollIntoView();
      await Reflect.get(element, 'ready');
      const canvas = element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
      const context = canvas.getContext('2d') as CanvasRenderingContext2D;
      const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
      const hash = pixels.reduce((sum, pixel) => (Math.imul(sum, 31) + pixel) | 0, 0);
      shown.push({ colors: new Set(pixels).size, hash });
    }
    return shown;
  });

test('every picture of the first page is drawn, under its content security policy', async () => {
  await browser.goto(`${server.url}examples/`);
  const shown = await pictures();
  assert.ok(shown.length > 0);
  for (const { colors } of shown) assert.ok(colors > 50);
});

test('the classic moves', async () => {
  await browser.goto(`${server.url}examples/classic.html`);
  const [first] = await pictures();
  await browser.execute(() => new Promise((resolve) => setTimeout(resolve, 500)));
  const [second] = await pictures();
  assert.notEqual(first?.hash, second?.hash);
});

test('twenty elements draw', async () => {
  await browser.goto(`${server.url}test/e2e/fixtures/page.html`);
  await browser.execute(() => {
    const markup = (hue: number) =>
      `<ray-scene integrator="direct" samples="4"><ray-sphere color="hsl(${18 * hue} 80% 50%)"></ray-sphere></ray-scene>`;
    document.body.innerHTML = Array.from({ length: 20 }, (_, hue) => markup(hue)).join('');
  });
  const shown = await pictures();
  assert.equal(shown.length, 20);
  assert.equal(new Set(shown.map(({ hash }) => hash)).size, 20);
  for (const { colors } of shown) assert.ok(colors > 50);
});
