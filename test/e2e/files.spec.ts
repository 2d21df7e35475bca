/** The README's first page, with the files beside it that the README says to copy. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { expect, type Page } from '@playwright/test';
import { completed, picture, test } from './fixtures/watch.ts';

const DIST = new URL('../../packages/ray-scene/dist/', import.meta.url).pathname;
const README = readFileSync(new URL('../../README.md', import.meta.url), 'utf8');
const MARKUP = /```html\n(.*?)```/s.exec(README)?.[1] ?? '';
const WHOLE = 'ray-scene.whole.min.js';

/** A page of its own, beside copies of these files of the build. Returns what it asks for in vain. */
async function open(page: Page, markup: string, isCopied: (file: string) => boolean): Promise<string[]> {
  const missing: string[] = [];
  await page.route('http://copied.test/**', async (route) => {
    const file = basename(new URL(route.request().url()).pathname);
    if (file === 'page.html') return route.fulfill({ contentType: 'text/html', body: `<!doctype html>${markup}` });
    if (isCopied(file) && existsSync(DIST + file)) return route.fulfill({ path: DIST + file });
    missing.push(file);
    return route.fulfill({ status: 404 });
  });
  await page.goto('http://copied.test/page.html');
  return missing;
}

const drawsARedBall = async (page: Page): Promise<void> => {
  await page.locator('ray-scene').evaluate((element) => {
    element.style.width = '96px';
    Object.assign(element, { samples: 4, pixelRatio: 1 });
  });
  // Before, there are previews of few pixels.
  await completed(page);
  expect((await picture(page)).colors).toBeGreaterThan(500);
};

test('the page of the README is a picture beside the files that it says to copy', async ({ page, complaints }) => {
  const files = readdirSync(DIST).filter((file) => file.startsWith('ray-scene.min.'));
  expect(files.length).toBeGreaterThan(10);
  const missing = await open(page, MARKUP, (file) => files.includes(file));
  await drawsARedBall(page);
  expect(missing.filter((file) => file.endsWith('.js'))).toEqual([]);
  expect(complaints.filter((text) => !text.includes('404'))).toEqual([]);
});

test('and beside the one file with everything in it', async ({ page, complaints }) => {
  const missing = await open(page, MARKUP.replace('ray-scene.min.js', WHOLE), (file) => file === WHOLE);
  await drawsARedBall(page);
  await page.locator('ray-sphere').evaluate((sphere) => sphere.setAttribute('raduis', '2'));
  await expect(page.getByRole('alert')).toContainText('did you mean "radius"?');
  expect(missing.filter((file) => file.endsWith('.js'))).toEqual([]);
  expect(complaints.filter((text) => !text.includes('404') && !text.includes('raduis'))).toEqual([]);
});
