import { expect } from '@open-wc/testing';
import { WebGLUnavailableError } from '../../packages/ray-scene/src/renderer.ts';
import { overlayOf, QuietConsole, rejection, sceneWith } from './element-fixtures.ts';

describe('<ray-scene> without WebGL2', () => {
  const original = HTMLCanvasElement.prototype.getContext;
  let quiet: QuietConsole;
  beforeEach(() => {
    quiet = new QuietConsole();
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: [string]) {
      return args[0] === 'webgl2' ? null : original.apply(this, args);
    } as typeof original;
  });
  afterEach(() => {
    HTMLCanvasElement.prototype.getContext = original;
    quiet.restore();
  });

  it('says so, and shows what the author put there for this case', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere><p>A red ball.</p>');
    const error = await rejection(element.ready);
    expect(error).to.be.instanceOf(WebGLUnavailableError);
    expect(error.message).to.match(/^This picture needs WebGL 2, and the browser does not provide it: /);
    await element.updateComplete;
    expect(overlayOf(element)).to.equal(error.message);
    expect(quiet.lines).to.deep.equal([error.message]);
    const fallback = element.querySelector('p') as HTMLElement;
    expect(getComputedStyle(fallback).visibility).to.equal('visible');
    expect(fallback.offsetHeight).to.be.above(0);
  });

  it('tries again when it is put back', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await rejection(element.ready);
    HTMLCanvasElement.prototype.getContext = original;
    const { parentElement } = element;
    element.remove();
    parentElement?.append(element);
    await element.ready;
    await element.updateComplete;
    expect(overlayOf(element)).to.equal(undefined);
  });
});
