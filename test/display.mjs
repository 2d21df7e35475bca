// The system's Firefox and WebKit need a display; where there is none, Xvfb serves an invisible one.
import { needsDisplay } from './browsers.mjs';
import { startChild } from './child-process.mjs';

/** Whether one of these browsers needs a display where there is none. */
export function lacksDisplay(browsers) {
  const hasDisplay = process.platform !== 'linux' || process.env.DISPLAY || process.env.WAYLAND_DISPLAY;
  return !hasDisplay && browsers.some(needsDisplay);
}

/** @param {import('./browsers.mjs').Browser[]} browsers those about to be launched */
export async function ensureDisplay(browsers) {
  if (lacksDisplay(browsers)) process.env.DISPLAY = `:${await startXvfb()}`;
}

function startXvfb() {
  const args = ['-displayfd', '3', '-screen', '0', '1280x1024x24', '-nolisten', 'tcp'];
  const xvfb = startChild('Xvfb', args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  return new Promise((resolve, reject) => {
    xvfb.once('error', reject);
    xvfb.once('exit', (code) => reject(new Error(`Xvfb ended with code ${code} before it had a display`)));
    // The number and its newline may arrive apart, and Xvfb dies when the pipe is closed in between: it stays open.
    let text = '';
    const pipe = /** @type {import('node:net').Socket} */ (xvfb.stdio[3]);
    pipe.on('data', (chunk) => {
      text += chunk;
      if (!text.includes('\n')) return;
      // From here on the display alone keeps nobody waiting.
      pipe.unref();
      xvfb.unref();
      resolve(text.trim());
    });
  });
}
