import { expect, fixture, oneEvent } from '@open-wc/testing';
import { type RayScene, type RaySceneCompleteEvent, RaySceneLoadEvent } from '../../packages/ray-scene/src/index.ts';
import { RenderDevice } from '../../packages/ray-scene/src/renderer.ts';
import {
  canvasIn,
  countEvents,
  middlePixel,
  partOf,
  sceneWith,
  someFrames,
  until,
  untilAtRest,
} from './element-fixtures.ts';

const BALL = '<ray-sphere color="red"></ray-sphere>';

describe('life of <ray-scene>', () => {
  it('tells of its picture by events that stay where they are', async () => {
    const host = document.createElement('div');
    const heard = ['load', 'progress', 'complete'].map((type) => countEvents(host, type));
    const element = document.createElement('ray-scene');
    Object.assign(element, { samples: 3, pixelRatio: 1, scene: { objects: [{ type: 'sphere' }] } });
    element.style.width = '60px';
    const load = oneEvent<RaySceneLoadEvent>(element, 'load');
    const complete = oneEvent<RaySceneCompleteEvent>(element, 'complete');
    const progress = countEvents(element, 'progress');
    host.append(element);
    document.body.append(host);
    expect(await load).to.be.instanceOf(RaySceneLoadEvent);
    expect((await load).scene).to.equal(element.scene);
    expect(await complete).to.include({ samples: 3, total: 3, reason: 'samples', bubbles: false, composed: false });
    expect((await complete).error).to.equal(element.stats?.error);
    expect(element.stats?.error).to.be.within(0, 1);
    expect(progress.count).to.be.within(1, 3);
    expect(heard.map(({ count }) => count)).to.deep.equal([0, 0, 0]);
    host.remove();
  });

  it('tells of progress also while only some of the picture gets samples', async () => {
    const half = '<ray-quad corner="0 -9 -1" edge-u="9 0 0" edge-v="0 18 0" emission="white"></ray-quad>';
    const element = await sceneWith(`${half}<ray-sphere center="-1 0 0"></ray-sphere>`, 'integrator="path"');
    Object.assign(element, { samples: 1000, maxError: 0.004 });
    element.style.width = '192px';
    const heard: { readonly told: number; readonly least: number | undefined }[] = [];
    element.addEventListener('progress', ({ samples }) => heard.push({ told: samples, least: element.stats?.samples }));
    await until(() => heard.some(({ told, least }) => least && told > least + 1));
  });

  it('renews its promises with every edit', async () => {
    const element = await sceneWith(BALL);
    const first = element.complete;
    await first;
    expect(element.complete).to.equal(first);
    partOf(element, 'ray-sphere').setAttribute('color', 'blue');
    const second = element.complete;
    expect(second).to.not.equal(first);
    await second;
    expect(middlePixel(element)[0]).to.be.below(middlePixel(element)[2] ?? 0);
    partOf(element, 'ray-sphere').remove();
    await element.ready;
    expect(middlePixel(element)).to.deep.equal([0, 0, 0, 0]);
  });

  it('ends when the noise is low enough, or when the time is up', async () => {
    const element = await sceneWith(BALL, 'max-error="0.1"');
    element.samples = 2 ** 20;
    const { reason, error } = await oneEvent<RaySceneCompleteEvent>(element, 'complete');
    expect(reason).to.equal('error');
    expect(error).to.be.within(0, 0.1);
    // A pause before the next frame counts as up to a second: with less, no sample may be added of which there is to tell.
    const maxTime = (element.stats?.seconds ?? 0) + 2;
    Object.assign(element, { maxError: null, maxTime });
    const second = await oneEvent<RaySceneCompleteEvent>(element, 'complete');
    expect(second.reason).to.equal('time');
    expect(element.stats?.seconds).to.be.at.least(maxTime);
  });

  it('fits the pixels of the screen, and follows', async () => {
    const element = await fixture<RayScene>(`<ray-scene style="width: 60px" samples="1">${BALL}</ray-scene>`);
    await element.ready;
    expect(getComputedStyle(element).display).to.equal('block');
    expect(element.clientHeight).to.equal(40);
    const pixels = (length: number): number => Math.round(length * devicePixelRatio);
    expect([canvasIn(element).width, canvasIn(element).height]).to.deep.equal([pixels(60), pixels(40)]);
    Object.assign(element.style, { width: '30px', aspectRatio: '1' });
    await until(() => canvasIn(element).width === pixels(30) && canvasIn(element).height === pixels(30));
    element.pixelRatio = 2;
    await until(() => canvasIn(element).width === 60);
    expect(element.stats).to.include({ width: 60, height: 60 });
  });

  it('is as wide as its place, and 300 pixels where that has no width of its own', async () => {
    const element = document.createElement('ray-scene');
    const place = await fixture<HTMLElement>('<div></div>');
    place.append(element);
    await element.updateComplete;
    const sizeIn = (style: string): readonly [number, number] => {
      place.style.cssText = style;
      const { width, height } = element.getBoundingClientRect();
      expect(place.scrollWidth).to.be.at.most(Math.ceil(place.clientWidth));
      return [width, height];
    };
    expect(sizeIn('width: 600px')).to.deep.equal([600, 400]);
    expect(sizeIn('width: 90px')).to.deep.equal([90, 60]);
    expect(sizeIn('display: flex; width: 600px')[0]).to.equal(300);
    expect(sizeIn('display: flex; width: 90px')[0]).to.equal(90);
    expect(sizeIn('display: inline-block')).to.deep.equal([300, 200]);
  });

  it('lets go of the GPU when it leaves the page, and works on where it is put', async () => {
    const element = await sceneWith(BALL, 'samples="1000000"');
    const [there, here] = [document.createElement('div'), element.parentElement];
    document.body.append(there);
    await element.ready;
    there.append(element);
    await element.ready;
    await until(() => (element.stats?.samples ?? 0) > 0);
    element.remove();
    expect(element.stats).to.equal(undefined);
    expect(middlePixel(element)[3]).to.equal(255);
    const progress = countEvents(element, 'progress');
    await someFrames(5);
    expect(progress.count).to.equal(0);
    partOf(element, 'ray-sphere').setAttribute('color', 'blue');
    here?.append(element);
    await element.ready;
    expect(middlePixel(element)[0]).to.be.below(middlePixel(element)[2] ?? 0);
    there.remove();
  });

  it('rests when nobody sees it, when it is done and when it is paused', async () => {
    const element = await sceneWith(BALL, 'samples="1000000"');
    await element.ready;
    element.style.display = 'none';
    await untilAtRest(element);
    const progress = countEvents(element, 'progress');
    element.style.display = '';
    await until(() => progress.count > 0);
    element.paused = true;
    await untilAtRest(element);
    Object.assign(element, { paused: false, samples: 1 });
    await element.complete;
    progress.count = 0;
    await someFrames(5);
    expect(progress.count).to.equal(0);
  });

  it('shows an edit while it is paused', async () => {
    const element = await sceneWith(BALL, 'paused');
    await element.ready;
    partOf(element, 'ray-sphere').setAttribute('color', 'blue');
    await element.ready;
    expect(middlePixel(element)[0]).to.be.below(middlePixel(element)[2] ?? 0);
  });

  it('makes an image file', async () => {
    const element = await sceneWith(BALL);
    const blob = await element.toBlob();
    expect(blob.type).to.equal('image/png');
    const image = await createImageBitmap(blob);
    expect([image.width, image.height]).to.deep.equal([60, 40]);
  });

  it('shows a poster until there is a picture', async () => {
    const element = await sceneWith('<p slot="poster">Wait</p>', 'src="never.json" poster="data:,"');
    const poster = element.shadowRoot?.querySelector<HTMLElement>('[part=poster]');
    expect(poster?.hidden).to.equal(false);
    element.scene = { objects: [{ type: 'sphere' }] };
    await element.ready;
    await element.updateComplete;
    expect(poster?.hidden).to.equal(true);
  });

  it('draws again after the context was lost', async () => {
    const element = await sceneWith(BALL);
    await element.complete;
    const context = RenderDevice.shared.gl.getExtension('WEBGL_lose_context');
    const lost = oneEvent(RenderDevice.shared.gl.canvas, 'webglcontextlost');
    context?.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve));
    const complete = oneEvent(element, 'complete');
    context?.restoreContext();
    await complete;
    expect(element.stats?.samples).to.equal(2);
  });

  it('shares one context with nineteen others', async () => {
    const original = HTMLCanvasElement.prototype.getContext;
    const contexts = new Set<unknown>();
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: [string]) {
      const context = original.apply(this, args);
      if (args[0].startsWith('webgl')) contexts.add(context);
      return context;
    } as typeof original;
    const scene = `<ray-scene style="width: 60px; float: left" samples="2" pixel-ratio="1">${BALL}</ray-scene>`;
    const page = await fixture<HTMLElement>(`<div>${scene.repeat(20)}</div>`);
    const elements = [...page.querySelectorAll('ray-scene')];
    await Promise.all(elements.map((element) => element.complete));
    HTMLCanvasElement.prototype.getContext = original;
    expect(elements.map((element) => middlePixel(element)[3])).to.deep.equal(Array(20).fill(255));
    // None, if another test of this page has made it already.
    expect(contexts.size).to.be.at.most(1);
  });
});

describe('accessibility of <ray-scene>', () => {
  const states: { readonly [name: string]: readonly [content: string, attributes: string] } = {
    'a picture': [BALL, 'alt="A red ball"'],
    'a picture without a name': [BALL, ''],
    'a decoration': [BALL, 'alt=""'],
    'a decoration with controls': [BALL, 'alt="" camera-controls'],
    'a picture with controls': [BALL, 'alt="A red ball" camera-controls'],
    'an error': ['<ray-sphere radius="0"></ray-sphere>', 'alt="A red ball"'],
  };

  for (const [name, [content, attributes]] of Object.entries(states)) {
    it(`has no faults with ${name}`, async function () {
      this.timeout(60_000);
      const original = console.error;
      console.error = () => {};
      const element = await sceneWith(content, attributes);
      await element.ready.catch(() => {});
      await element.updateComplete;
      await expect(element).to.be.accessible();
      console.error = original;
    });
  }

  it('has a name whatever the author says', async () => {
    const element = await sceneWith(BALL);
    const canvas = canvasIn(element);
    const label = async (): Promise<string | null> => {
      await element.ready;
      await element.updateComplete;
      return canvas.getAttribute('aria-label');
    };
    expect(canvas.getAttribute('role')).to.equal('img');
    expect(await label()).to.equal('Ray-traced scene');
    element.scene = { name: 'A planet', objects: [{ type: 'sphere' }] };
    expect(await label()).to.equal('A planet');
    element.alt = 'A red ball';
    expect(await label()).to.equal('A red ball');
  });

  it('is a decoration where its author says so, but not what can have the focus', async () => {
    const element = await sceneWith(BALL, 'alt=""');
    const told = async (): Promise<readonly (string | null)[]> => {
      await element.ready;
      await element.updateComplete;
      return ['role', 'aria-label'].map((name) => canvasIn(element).getAttribute(name));
    };
    expect(await told()).to.deep.equal(['none', null]);
    element.cameraControls = true;
    expect(await told()).to.deep.equal(['img', 'Ray-traced scene']);
    element.scene = { name: 'A planet', objects: [{ type: 'sphere' }] };
    expect(await told()).to.deep.equal(['img', 'A planet']);
    element.cameraControls = false;
    expect(await told()).to.deep.equal(['none', null]);
    element.removeAttribute('alt');
    expect(await told()).to.deep.equal(['img', 'A planet']);
  });

  it('lets parts of a scene have the focus', async () => {
    const element = await sceneWith('<ray-sphere tabindex="0" aria-label="Ball"></ray-sphere><p tabindex="0">Text</p>');
    await element.ready;
    partOf(element, 'ray-sphere').focus();
    expect(document.activeElement).to.equal(partOf(element, 'ray-sphere'));
    element.querySelector('p')?.focus();
    expect(document.activeElement).to.not.equal(element.querySelector('p'));
  });
});
