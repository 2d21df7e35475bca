// Which binary stands for each browser engine, and how it is launched.
import { existsSync, readdirSync } from 'node:fs';
import { delimiter, join } from 'node:path';

export const ENGINES = ['chromium', 'firefox', 'webkit'];

const SYSTEM_NAMES = {
  chromium: ['chromium', 'chromium-browser', 'google-chrome'],
  firefox: ['firefox-esr', 'firefox'],
};

const LAUNCH_OPTIONS = {
  // The software renderer gives the same pixels whatever graphics card a machine has.
  chromium: { args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'] },
  firefox: { firefoxUserPrefs: { 'webgl.force-enabled': true } },
  webkit: {},
};

/**
 * @typedef {object} Browser
 * @property {'chromium' | 'firefox' | 'webkit'} engine
 * @property {string} binary
 * @property {boolean} managed installed by Playwright, which then launches it by itself
 * @property {string} why what the choice rests on, for people
 */

/**
 * An environment variable that names a binary wins; then Playwright's own browser if it is installed; then the
 * system's. The file system is a parameter for the sake of the tests.
 * @returns {Browser | undefined}
 */
export function chooseBrowser(engine, { env, managedPath, exists, systemPath }) {
  const variable = `RAY_SCENE_${engine.toUpperCase()}`;
  const override = env[variable];
  if (override) {
    if (!exists(override)) throw new Error(`${variable} names ${override}, which does not exist`);
    return { engine, binary: override, managed: override === managedPath, why: variable };
  }
  if (exists(managedPath)) return { engine, binary: managedPath, managed: true, why: "Playwright's" };
  const binary = systemPath(engine);
  return binary ? { engine, binary, managed: false, why: "the system's" } : undefined;
}

/** Where a command is, if it is on the path. */
export function onPath(name) {
  return (process.env.PATH ?? '')
    .split(delimiter)
    .map((folder) => join(folder, name))
    .find(existsSync);
}

/** WebKitGTK has no command of its own: a driver on the path starts the small browser beside the library. */
function systemWebKit() {
  if (!onPath('WebKitWebDriver')) return undefined;
  for (const lib of ['/usr/lib', '/usr/libexec', '/usr/lib64'].filter(existsSync)) {
    const folders = [
      lib,
      ...readdirSync(lib, { withFileTypes: true })
        .filter((e) => e.isDirectory())
        .map((e) => join(lib, e.name)),
    ];
    for (const folder of folders) {
      const binary = ['webkitgtk-6.0', 'webkit2gtk-4.1', 'webkit2gtk-4.0']
        .map((api) => join(folder, api, 'MiniBrowser'))
        .find(existsSync);
      if (binary) return binary;
    }
  }
  return undefined;
}

function systemPath(engine) {
  return engine === 'webkit' ? systemWebKit() : SYSTEM_NAMES[engine].map(onPath).find(Boolean);
}

/** @returns {Promise<Browser | undefined>} */
export async function findBrowser(engine) {
  const playwright = await import('playwright');
  const managedPath = playwright[engine].executablePath();
  return chooseBrowser(engine, { env: process.env, managedPath, exists: existsSync, systemPath });
}

/** All engines, or those that RAY_SCENE_ENGINES lists ("chromium,webkit"). */
export function wantedEngines() {
  const wanted = process.env.RAY_SCENE_ENGINES?.split(',') ?? ENGINES;
  const unknown = wanted.filter((engine) => !ENGINES.includes(engine));
  if (unknown.length > 0) throw new Error(`RAY_SCENE_ENGINES takes ${ENGINES.join(', ')}, not ${unknown.join(', ')}`);
  return wanted;
}

/** The browsers that this machine has for the wanted engines. */
export async function findBrowsers() {
  const found = await Promise.all(wantedEngines().map(findBrowser));
  return /** @type {Browser[]} */ (found.filter(Boolean));
}

/** Playwright drives every browser but the system's WebKit, which has a WebDriver instead. */
export const needsWebDriver = ({ engine, managed }) => engine === 'webkit' && !managed;

/** Playwright's browsers and the system's Chromium run without a window, with WebGL; the others cannot. */
export const needsDisplay = ({ engine, managed }) => engine !== 'chromium' && !managed;

/** What Playwright's `launch` takes. The system's Firefox speaks WebDriver BiDi and has WebGL only with a window. */
export function launchOptions({ engine, binary, managed }) {
  const options = LAUNCH_OPTIONS[engine];
  if (managed) return options;
  if (engine === 'firefox') return { ...options, executablePath: binary, channel: 'moz-firefox', headless: false };
  return { ...options, executablePath: binary };
}
