/** The built element on pages of its own: many at once, with mistakes, and without WebGL. */
import { expect, type Page } from '@playwright/test';
import { picture, test } from './fixtures/watch.ts';

/** An empty page with the element defined, and some markup on it. */
async function show(page: Page, markup: string): Promise<void> {
  await page.goto('/test/e2e/fixtures/page.html');
  await page.evaluate((html) => {
    document.body.innerHTML = html;
  }, markup);
}

test('twenty elements draw, with one context', async ({ page, complaints }) => {
  await page.addInitScript(() => {
    const contexts = new Set<unknown>();
    Reflect.set(window, 'contexts', contexts);
    for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
      const original = prototype.getContext as (...args: unknown[]) => unknown;
      prototype.getContext = function (this: unknown, ...args: unknown[]) {
        const context = original.apply(this, args);
        if (String(args[0]).startsWith('webgl')) contexts.add(context);
        return context;
      } as never;
    }
  });
  const markup = (hue: number) =>
    `<ray-scene integrator="direct" samples="4"><ray-sphere color="hsl(${18 * hue} 80% 50%)"></ray-sphere></ray-scene>`;
  await show(page, Array.from({ length: 20 }, (_, hue) => markup(hue)).join(''));
  const hashes = new Set<number>();
  for (let n = 0; n < 20; n++) {
    const { colors, hash } = await picture(page, n);
    expect(colors).toBeGreaterThan(50);
    hashes.add(hash);
  }
  expect(hashes.size).toBe(20);
  expect(await page.evaluate(() => Reflect.get(window, 'contexts').size)).toBe(1);
  expect(complaints).toEqual([]);
});

test('a simple scene is drawn without other parts; a camera that goes into a ball loads some', async ({
  page,
  complaints,
}) => {
  const parts: string[] = [];
  page.on('request', (request) => parts.push(...(/\w+-parts(?=\.js$)/.exec(request.url()) ?? [])));
  // Where the processor draws, all scenes need the other file.
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const original = prototype.getParameter;
    prototype.getParameter = function (this: WebGL2RenderingContext, name: GLenum) {
      const value: unknown = original.call(this, name);
      return typeof value === 'string' ? 'some graphics card' : value;
    };
  });
  const lamp = '<ray-light position="2 3 4" intensity="80"></ray-light>';
  await show(page, `<ray-scene integrator="direct" samples="4">${lamp}<ray-sphere></ray-sphere></ray-scene>`);
  const { hash } = await picture(page);
  expect(parts).toEqual([]);
  const inside = await page.locator('ray-scene').evaluate(async (element) => {
    Reflect.set(element, 'camera', { position: [0.5, 0, 0] });
    await Reflect.get(element, 'complete');
    return Reflect.get(element, 'stats');
  });
  expect(inside).toMatchObject({ samples: 4, compiles: 2 });
  expect(parts).toEqual(['more-parts']);
  expect((await picture(page)).hash).not.toBe(hash);
  expect(complaints).toEqual([]);
});

test('a misspelt attribute is told in the element, once on the console, and as an event', async ({ page }) => {
  const told: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') told.push(message.text());
  });
  await page.goto('/test/e2e/fixtures/page.html');
  const problems = await page.evaluate(
    () =>
      new Promise<unknown>((resolve) => {
        const scene = document.createElement('ray-scene');
        scene.addEventListener('error', (event) => resolve(Reflect.get(event, 'problems')));
        scene.innerHTML = '<ray-sphere></ray-sphere><ray-sphere raduis="2"></ray-sphere>';
        document.body.append(scene);
      }),
  );
  const message =
    'unknown attribute "raduis" (did you mean "radius"?). A sphere takes: center, radius, name, material, color, ' +
    'metalness, roughness, ior, specular, specular-color, transmission, attenuation-color, attenuation-distance, ' +
    'emission, emission-intensity, emission-side, checker, checker-size, map.';
  expect(problems).toMatchObject([{ where: 'ray-scene > ray-sphere[2]', message }]);
  await expect(page.getByRole('alert')).toHaveText(`ray-scene > ray-sphere[2]: ${message}`);
  expect(told).toEqual([`ray-scene > ray-sphere[2]: ${message}`]);
});

test('a file that is not there is told', async ({ page }) => {
  await show(page, '<ray-scene src="/examples/scenes/nothing.json"></ray-scene>');
  await expect(page.getByRole('alert')).toContainText('404');
  await expect(page.getByRole('alert')).toContainText('nothing.json');
});

test('without WebGL the element says so', async ({ page }) => {
  await page.addInitScript(() => {
    const { prototype } = HTMLCanvasElement;
    const original = prototype.getContext as (...args: unknown[]) => unknown;
    prototype.getContext = function (this: unknown, ...args: unknown[]) {
      return args[0] === 'webgl2' ? null : original.apply(this, args);
    } as never;
  });
  await show(page, '<ray-scene><ray-sphere></ray-sphere></ray-scene>');
  await expect(page.getByRole('alert')).toContainText('needs WebGL 2');
});
