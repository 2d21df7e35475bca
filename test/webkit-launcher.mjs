// Lets web-test-runner run its pages in the system's WebKit.
import { openWebKit } from './webdriver.mjs';

const BUTTONS = { left: 0, middle: 1, right: 2 };

/**
 * web-test-runner's BrowserLauncher (see its API documentation), with one page at a time in one window. The type and
 * the methods from sendKeys on are what @web/test-runner-commands asks of a WebDriver launcher.
 */
export function webkitLauncher(browser) {
  /** @type {Awaited<ReturnType<typeof openWebKit>> | undefined} */
  let window;
  let activeSession = '';

  const close = async () => {
    await window?.close();
    window = undefined;
  };

  return {
    name: 'Webkit',
    type: 'webdriver',
    concurrency: 1,
    isActive: (sessionId) => sessionId === activeSession,
    getBrowserUrl: () => window?.url(),
    stop: close,

    async startSession(sessionId, url) {
      window ??= await openWebKit(browser);
      activeSession = sessionId;
      await window.goto(url);
    },

    async stopSession() {
      activeSession = '';
      // A page that hangs or crashed takes its window with it; the next page gets a new one.
      await window?.goto('about:blank').catch(close);
      return {};
    },

    async startDebugSession() {
      throw new Error('Debugging is not supported in WebKit');
    },

    async sendKeys(_sessionId, keys) {
      for (const key of keys) await window?.press(...(key === '+' ? [key] : key.split('+')));
    },
    sendMouseMove: (_sessionId, x, y) => window?.mouse({ type: 'pointerMove', x, y }),
    sendMouseClick: (_sessionId, x, y, button = 'left') => window?.click(x, y, BUTTONS[button]),
    sendMouseDown: (_sessionId, button = 'left') => window?.mouse({ type: 'pointerDown', button: BUTTONS[button] }),
    sendMouseUp: (_sessionId, button = 'left') => window?.mouse({ type: 'pointerUp', button: BUTTONS[button] }),
    resetMouse: () => window?.mouse({ type: 'pointerUp', button: 0 }, { type: 'pointerMove', x: 0, y: 0 }),
  };
}
