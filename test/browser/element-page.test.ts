import { expect } from '@open-wc/testing';
import type { RayScene } from '../../packages/ray-scene/src/index.ts';
import { until } from './element-fixtures.ts';

const SCRIPT = new URL('../../packages/ray-scene/src/index.ts', import.meta.url).href;
const BALL = '<ray-scene samples="1"><ray-sphere></ray-sphere></ray-scene>';

describe('a page with <ray-scene>', function () {
  // Each frame loads all modules one by one, beside two other browsers that do: on two cores that took a minute once.
  this.timeout(300_000);
  let frame: HTMLIFrameElement;
  beforeEach(() => {
    frame = document.createElement('iframe');
    frame.style.cssText = 'width: 100px; height: 100px';
  });
  afterEach(() => frame.remove());

  /** The frame's document, as it is now. */
  const page = (): Document => {
    if (!frame.contentDocument) throw new Error('no document');
    return frame.contentDocument;
  };
  const element = (): RayScene => page().querySelector('ray-scene') as RayScene;

  it('that is still loading is read when the element is whole', async () => {
    document.body.append(frame);
    const { contentDocument, contentWindow } = frame;
    if (!contentDocument || !contentWindow) throw new Error('no frame');
    contentDocument.open();
    contentDocument.write(`<!doctype html><body><script type="module" async src="${SCRIPT}"></script>`);
    contentDocument.write('<ray-scene samples="1"><ray-sphere></ray-sphere>');
    await until(() => element()?.shadowRoot);
    for (let i = 0; i < 5; i++) await new Promise((resolve) => contentWindow.requestAnimationFrame(resolve));
    expect(contentDocument.readyState).to.equal('loading');
    expect(element().scene).to.equal(undefined);
    contentDocument.write('<ray-plane></ray-plane></ray-scene><p>More');
    await element().ready;
    expect(contentDocument.readyState).to.equal('loading');
    expect(element().scene?.objects.map(({ type }) => type)).to.deep.equal(['sphere', 'plane']);
    contentDocument.close();
  });

  it('may have a strict policy', async () => {
    frame.src = new URL('strict-policy.html', import.meta.url).href;
    document.body.append(frame);
    await until(() => element());
    const violations: string[] = [];
    page().addEventListener('securitypolicyviolation', (event) => violations.push(event.violatedDirective));
    await until(() => element().shadowRoot);
    await element().complete;
    expect(violations).to.deep.equal([]);
    expect(element().clientHeight).to.be.above(0);
    expect(getComputedStyle(element()).display).to.equal('block');
  });

  it('may bring markup and script in any order', async () => {
    frame.srcdoc = `<!doctype html>${BALL}<script type="module" src="${SCRIPT}"></script>`;
    document.body.append(frame);
    await until(() => element()?.shadowRoot);
    await element().complete;
    expect(element().scene?.objects).to.have.lengthOf(1);
  });
});
