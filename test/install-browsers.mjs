// Makes sure that there is a browser for every engine: Playwright's where it can be downloaded, else the system's.
import { spawnSync } from 'node:child_process';
import { findBrowser, findBrowsers, onPath, wantedEngines } from './browsers.mjs';
import { lacksDisplay } from './display.mjs';

// WebKit's driver brings its browser, Mesa the WebGL of both Firefox and WebKit.
const SYSTEM_PACKAGES = {
  chromium: ['chromium'],
  firefox: ['firefox-esr', 'libgl1-mesa-dri'],
  webkit: ['webkit2gtk-driver', 'libgl1-mesa-dri'],
};

function run(command, ...args) {
  console.log(`> ${command} ${args.join(' ')}`);
  return spawnSync(command, args, { stdio: 'inherit', shell: process.platform === 'win32' }).status === 0;
}

/** The download comes first: where it fails, nothing of the system has been changed. */
function installManaged(engine) {
  return run('npx', 'playwright', 'install', engine) && run('npx', 'playwright', 'install-deps', engine);
}

function aptInstall(packages) {
  const isRoot = process.getuid?.() === 0;
  const canSudo = !isRoot && spawnSync('sudo', ['-n', 'true'], { stdio: 'ignore' }).status === 0;
  if (packages.length === 0 || !onPath('apt-get') || !(isRoot || canSudo)) return;
  const apt = isRoot ? ['apt-get'] : ['sudo', '-n', 'apt-get'];
  if (run(...apt, 'update')) run(...apt, 'install', '-y', ...packages);
}

async function missingEngines() {
  const engines = wantedEngines();
  const found = await Promise.all(engines.map(findBrowser));
  return engines.filter((_, i) => !found[i]);
}

async function missingPackages() {
  const packages = (await missingEngines()).flatMap((engine) => SYSTEM_PACKAGES[engine]);
  // Firefox and WebKit, once installed, want a display.
  const needXvfb = packages.includes('libgl1-mesa-dri') || lacksDisplay(await findBrowsers());
  if (needXvfb && !onPath('Xvfb')) packages.push('xvfb');
  return [...new Set(packages)];
}

/** Installs what is missing. @returns {Promise<string[]>} the engines that have no browser even so */
export async function installBrowsers() {
  for (const engine of await missingEngines()) installManaged(engine);
  aptInstall(await missingPackages());
  for (const { engine, binary, why } of await findBrowsers()) console.log(`${engine}: ${binary} (${why})`);
  return missingEngines();
}
