import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chooseBrowser, launchOptions, needsDisplay, needsWebDriver } from '../browsers.mjs';

const MANAGED = '/home/someone/.cache/ms-playwright/browser';
const SYSTEM = '/usr/bin/browser';
const OWN = '/opt/browser';

function choose(engine: string, env: Record<string, string>, existing: string[]) {
  const exists = (path: string) => existing.includes(path);
  const systemPath = () => (exists(SYSTEM) ? SYSTEM : undefined);
  return chooseBrowser(engine, { env, managedPath: MANAGED, exists, systemPath });
}

test('a named binary wins, then the managed browser, then that of the system', () => {
  const all = [OWN, MANAGED, SYSTEM];
  assert.equal(choose('firefox', { RAY_SCENE_FIREFOX: OWN }, all)?.binary, OWN);
  assert.equal(choose('firefox', { RAY_SCENE_CHROMIUM: OWN }, all)?.binary, MANAGED);
  assert.equal(choose('firefox', {}, [SYSTEM])?.binary, SYSTEM);
  assert.equal(choose('firefox', {}, []), undefined);
});

test('a named binary must exist', () => {
  const message = 'RAY_SCENE_WEBKIT names /opt/browser, which does not exist';
  assert.throws(() => choose('webkit', { RAY_SCENE_WEBKIT: OWN }, [SYSTEM]), { message });
});

test('a managed browser needs neither a display, nor a driver, nor a path, however it was chosen', () => {
  for (const env of [{}, { RAY_SCENE_WEBKIT: MANAGED }]) {
    const webkit = choose('webkit', env, [MANAGED, SYSTEM]);
    assert.ok(webkit);
    assert.ok(!needsWebDriver(webkit) && !needsDisplay(webkit));
    assert.deepEqual(launchOptions(webkit), {});
  }
});

test("the system's WebKit has a WebDriver, its Firefox a window", () => {
  const webkit = choose('webkit', {}, [SYSTEM]);
  const firefox = choose('firefox', {}, [SYSTEM]);
  assert.ok(webkit && firefox);
  assert.ok(needsWebDriver(webkit) && needsDisplay(webkit));
  assert.ok(!needsWebDriver(firefox) && needsDisplay(firefox));
  assert.equal(launchOptions(firefox).headless, false);
});
