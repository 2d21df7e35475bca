/** Every example page does what it says it does, without a complaint. */
import { readdirSync } from 'node:fs';
import { expect } from '@playwright/test';
import { completed, makeSmall, picture, stats, test } from './fixtures/watch.ts';

const pages = readdirSync('examples').filter((name) => name.endsWith('.html'));
const scenes = readdirSync('examples/scenes').map((name) => name.replace('.json', ''));

for (const name of pages) {
  test(`${name} draws under its content security policy, without a complaint`, async ({ page, complaints }) => {
    await page.goto(`/examples/${name}`);
    const count = await page.locator('ray-scene').count();
    expect(count).toBeGreaterThan(0);
    for (let n = 0; n < count; n++) expect((await picture(page, n)).colors).toBeGreaterThan(50);
    await expect(page.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute(
      'content',
      "script-src 'self'; style-src 'self'; require-trusted-types-for 'script'",
    );
    expect(complaints).toEqual([]);
  });

  test(`${name} fits a small telephone`, async ({ page }) => {
    await page.setViewportSize({ width: 360, height: 640 });
    await page.goto(`/examples/${name}`);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
  });
}

for (const name of ['classic.html', 'classic-src.html']) {
  test(`${name} moves, and stops when told to`, async ({ page, complaints }) => {
    await page.goto(`/examples/${name}`);
    await makeSmall(page);
    const { hash } = await picture(page);
    await expect.poll(async () => (await picture(page)).hash).not.toBe(hash);
    await page.getByRole('button', { name: 'Pause' }).click();
    await completed(page);
    const still = await picture(page);
    await page.waitForTimeout(300);
    expect(await picture(page)).toEqual(still);
    expect((await stats(page)).compiles).toBe(1);
    expect(complaints).toEqual([]);
  });
}

test('moving a slider changes the picture and compiles nothing', async ({ page }) => {
  await page.goto('/examples/live.html');
  await makeSmall(page);
  let before = await picture(page);
  const { compiles } = await stats(page);
  const sliders = page.locator('input[type=range]');
  for (let n = 0; n < (await sliders.count()); n++) {
    await sliders.nth(n).focus();
    await page.keyboard.press('PageDown');
    await expect.poll(async () => (await picture(page)).hash).not.toBe(before.hash);
    before = await picture(page);
  }
  expect((await stats(page)).compiles).toBe(compiles);
});

test('a first floor compiles one program, and bringing it back compiles none', async ({ page }) => {
  await page.goto('/examples/live.html');
  await makeSmall(page);
  const bare = await picture(page);
  const { compiles } = await stats(page);
  await page.getByRole('button', { name: 'Add a floor' }).click();
  await expect.poll(async () => (await picture(page)).hash).not.toBe(bare.hash);
  const { hash } = await picture(page);
  await page.getByRole('button', { name: 'Remove the floor' }).click();
  await expect.poll(async () => (await picture(page)).hash).not.toBe(hash);
  await page.getByRole('button', { name: 'Add a floor' }).click();
  await completed(page);
  expect((await stats(page)).compiles).toBe(compiles + 1);
});

test('a mistake in the JSON of scenes.html is told, and the last good picture stays', async ({ page }) => {
  await page.goto('/examples/scenes.html#hello');
  await makeSmall(page);
  await completed(page);
  const { hash } = await picture(page);
  const json = page.getByRole('textbox', { name: 'JSON of the scene' });
  await json.fill('{ "objects": [{ "type": "spere" }] }');
  await expect(page.getByRole('alert')).toHaveText(
    /^objects\[0\]: unknown type "spere" \(did you mean "sphere"\?\)\. Types of object: sphere, plane, .*\.$/,
  );
  expect((await picture(page)).hash).toBe(hash);
  await json.fill('{ "objects": [{ "type": "sphere" }] }');
  await expect(page.getByRole('alert')).toBeHidden();
  await expect.poll(async () => (await picture(page)).hash).not.toBe(hash);
});

for (const scene of scenes) {
  test(`the GPU's picture of ${scene} is that of the reference`, async ({ page, complaints }) => {
    test.slow();
    // All three pictures are in sight.
    await page.setViewportSize({ width: 900, height: 900 });
    await page.goto('/examples/reference.html');
    // The program of the first scene is kept, and must draw this one as well.
    await completed(page);
    await page.getByLabel('Scene', { exact: true }).selectOption(scene);
    const figure = async (name: string): Promise<number> => {
      const text = await page.getByRole('row', { name }).getByRole('cell').innerText();
      return Number.parseFloat(text) / (text.endsWith('%') ? 100 : 1);
    };
    await expect(page.locator('#state')).toHaveText(`done: ${scene}`, { timeout: 80_000 });
    const [median, share, excluded] = [await figure('Median'), await figure('Share'), await figure('Left out')];
    console.log(`${scene}: median ${median}, ${100 * share} % above 1e-3, ${100 * excluded} % left out`);
    expect(median).toBeLessThan(1e-5);
    expect(share).toBeLessThan(1e-3);
    expect(excluded).toBeLessThan(0.03);
    expect(complaints).toEqual([]);
  });
}
