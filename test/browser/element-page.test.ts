import { expect } from '@open-wc/testing';
import type { RayScene } from '../../packages/ray-scene/src/index.ts';
import { middlePixel, overlayOf, QuietConsole, sceneWith, until } from './element-fixtures.ts';

const SCRIPT = new URL('../../packages/ray-scene/src/index.ts', import.meta.url).href;
const BALL = '<ray-scene samples="1"><ray-sphere></ray-sphere></ray-scene>';

/** How the parts of an element are laid out: nothing of that is so without its style sheets. */
function layoutOf(host: RayScene): readonly unknown[] {
  const view = host.ownerDocument.defaultView;
  const parts = ['canvas', 'error', 'stats'].map((name) => host.shadowRoot?.querySelector(`[part=${name}]`));
  return [view?.getComputedStyle(host).display, ...parts.map((part) => part && view?.getComputedStyle(part).position)];
}

const LAID_OUT = ['block', 'absolute', 'absolute', 'absolute'];

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

  it('may take over an element of another page, and give it back', async () => {
    const quiet = new QuietConsole();
    document.body.append(frame);
    const content = '<ray-sphere></ray-sphere><ray-sphere radius="0"></ray-sphere>';
    const guest = await sceneWith(content, 'show-stats');
    const beside = await sceneWith(content, 'show-stats');
    const home = guest.parentElement as HTMLElement;
    await until(() => `${layoutOf(guest)}` === `${LAID_OUT}`);
    // Away from all documents that are seen, then from one to the other and back.
    const nowhere = document.implementation.createHTMLDocument();
    for (const place of [nowhere.body, page().body, home, page().body]) {
      place.append(guest);
      if (place === nowhere.body) continue;
      expect(layoutOf(guest).slice(0, 2)).to.deep.equal(['block', 'absolute']);
      await until(() => `${layoutOf(guest)}` === `${LAID_OUT}`);
      expect(overlayOf(guest)).to.match(/radius/);
      expect(guest.shadowRoot?.adoptedStyleSheets).to.have.lengthOf(3);
    }
    expect(layoutOf(beside)).to.deep.equal(LAID_OUT);
    guest.querySelector('[radius]')?.remove();
    await guest.complete;
    expect(middlePixel(guest)[3]).to.equal(255);
    guest.remove();
    expect(quiet.lines).to.have.lengthOf(2);
    quiet.restore();
  });

  it('may bring markup and script in any order', async () => {
    frame.srcdoc = `<!doctype html>${BALL}<script type="module" src="${SCRIPT}"></script>`;
    document.body.append(frame);
    await until(() => element()?.shadowRoot);
    await element().complete;
    expect(element().scene?.objects).to.have.lengthOf(1);
  });
});
