// A WebDriver client for the system's WebKit: the browser tests' launcher and the end-to-end tests share it.
import { once } from 'node:events';
import { createServer } from 'node:net';
import { setTimeout as wait } from 'node:timers/promises';
import { startChild } from './child-process.mjs';

const COMMAND_TIMEOUT_MS = 60_000;

// https://www.w3.org/TR/webdriver2/#keyboard-actions
const KEYS = {
  Backspace: '\uE003',
  Tab: '\uE004',
  Enter: '\uE007',
  Shift: '\uE008',
  Control: '\uE009',
  Alt: '\uE00A',
  Escape: '\uE00C',
  Space: ' ',
  PageUp: '\uE00E',
  PageDown: '\uE00F',
  End: '\uE010',
  Home: '\uE011',
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
  Delete: '\uE017',
  Meta: '\uE03D',
};

async function command(url, method, body) {
  const signal = AbortSignal.timeout(COMMAND_TIMEOUT_MS);
  const init = method === 'POST' ? { method, body: JSON.stringify(body ?? {}), signal } : { method, signal };
  const { value } = await (await fetch(url, init)).json();
  if (value?.error) throw new Error(`WebDriver: ${value.error}: ${value.message}`);
  return value;
}

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  server.close();
  return port;
}

async function startDriver() {
  const port = await freePort();
  const driver = startChild('WebKitWebDriver', [`--port=${port}`, '--host=127.0.0.1'], { stdio: 'ignore' });
  const url = `http://127.0.0.1:${port}`;
  for (let attempt = 0; attempt < 100; attempt++) {
    if (driver.exitCode !== null) break;
    const ready = await command(`${url}/status`, 'GET').then(
      (status) => status.ready,
      () => false,
    );
    if (ready) return { driver, url };
    await wait(100);
  }
  driver.kill();
  throw new Error('WebKitWebDriver did not start');
}

/** Starts a driver and its browser. One driver holds one session. */
export async function openWebKit({ binary }) {
  const { driver, url } = await startDriver();
  const options = { binary, args: ['--automation'] };
  const alwaysMatch = { browserName: 'MiniBrowser', 'webkitgtk:browserOptions': options };
  try {
    const { sessionId } = await command(`${url}/session`, 'POST', { capabilities: { alwaysMatch } });
    return new WebDriverSession(`${url}/session/${sessionId}`, driver);
  } catch (error) {
    driver.kill();
    throw error;
  }
}

/** One browser window. Positions are CSS pixels of the viewport. */
class WebDriverSession {
  #url;
  #driver;

  constructor(url, driver) {
    this.#url = url;
    this.#driver = driver;
  }

  #post(path, body) {
    return command(`${this.#url}/${path}`, 'POST', body);
  }

  goto(url) {
    return this.#post('url', { url });
  }

  url() {
    return command(`${this.#url}/url`, 'GET');
  }

  /** Runs a function of the page's world; a promise that it returns is awaited. */
  execute(script, ...args) {
    return this.#post('execute/sync', { script: `return (${script}).apply(null, arguments);`, args });
  }

  /** The window's inside as a PNG. */
  async screenshot() {
    return Buffer.from(await command(`${this.#url}/screenshot`, 'GET'), 'base64');
  }

  /** The whole window, its own bars included. */
  resize(width, height) {
    return this.#post('window/rect', { width, height });
  }

  /** Pointer actions as WebDriver has them: `mouse({ type: 'pointerMove', x, y }, { type: 'pointerDown', button: 0 })`. */
  mouse(...actions) {
    return this.#post('actions', {
      actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }],
    });
  }

  click(x, y, button = 0) {
    return this.mouse({ type: 'pointerMove', x, y }, { type: 'pointerDown', button }, { type: 'pointerUp', button });
  }

  drag([x, y], to) {
    const [toX, toY] = to;
    return this.mouse(
      { type: 'pointerMove', x, y },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerMove', x: toX, y: toY, duration: 100 },
      { type: 'pointerUp', button: 0 },
    );
  }

  wheel(x, y, deltaY) {
    const scroll = { type: 'scroll', x, y, deltaX: 0, deltaY };
    return this.#post('actions', { actions: [{ type: 'wheel', id: 'wheel', actions: [scroll] }] });
  }

  /** Presses keys together, named as in `KeyboardEvent.key`: `press('Shift', 'Tab')`. */
  press(...names) {
    const values = names.map((name) => KEYS[name] ?? name);
    const down = values.map((value) => ({ type: 'keyDown', value }));
    const up = values.reverse().map((value) => ({ type: 'keyUp', value }));
    return this.#post('actions', { actions: [{ type: 'key', id: 'keyboard', actions: [...down, ...up] }] });
  }

  async close() {
    await command(this.#url, 'DELETE').catch(() => {});
    this.#driver.kill();
  }
}
