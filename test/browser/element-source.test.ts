import { expect, oneEvent } from '@open-wc/testing';
import { parseScene, type SceneError } from '@ray-scene/core';
import { countEvents, partOf, QuietConsole, rejection, sceneWith, someFrames, until } from './element-fixtures.ts';

const named = (name: string) => JSON.stringify({ name, objects: [{ type: 'sphere' }] });
const addressOf = (text: string) => URL.createObjectURL(new Blob([text], { type: 'application/json' }));
const inline = (name: string) => `<script type="application/json">${named(name)}</script>`;

describe('sources of <ray-scene>', () => {
  it('takes child elements', async () => {
    const element = await sceneWith(`
      <ray-camera position="0 1 6" fov="40"></ray-camera>
      <ray-light type="point" position="4 6 4" intensity="300"></ray-light>
      <ray-light type="directional"></ray-light>
      <ray-environment top="white" bottom="black"></ray-environment>
      <ray-material name="red" color="crimson" checker-size="0.5"></ray-material>
      <ray-sphere center="0, 0, 0" radius="1" material="red"></ray-sphere>
      <ray-plane point="0 -1 0" color="white" checker="black"></ray-plane>`);
    await element.ready;
    expect(element.scene).to.deep.equal(
      parseScene({
        camera: { position: [0, 1, 6], fov: 40 },
        lights: [{ type: 'point', position: [4, 6, 4], intensity: 300 }, { type: 'directional' }],
        environment: { top: 'white', bottom: 'black' },
        materials: { red: { color: 'crimson', checkerSize: 0.5 } },
        objects: [
          { type: 'sphere', radius: 1, material: 'red' },
          { type: 'plane', point: [0, -1, 0], color: 'white', checker: 'black' },
        ],
      }),
    );
  });

  it('draws a picture of a sphere alone', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await element.complete;
    const radiance = element.readRadiance();
    expect(radiance.length).to.equal(60 * 40 * 4);
    expect(radiance[(20 * 60 + 30) * 4]).to.be.above(0);
    expect(radiance[3]).to.equal(0);
  });

  it('takes an inline script, and its edits', async () => {
    const element = await sceneWith(inline('first'));
    await element.ready;
    expect(element.scene?.name).to.equal('first');
    (element.firstElementChild as HTMLElement).textContent = named('second');
    await element.ready;
    expect(element.scene?.name).to.equal('second');
  });

  it('takes an address, and another one', async () => {
    const element = await sceneWith('', `src="${addressOf(named('first'))}"`);
    const loads = countEvents(element, 'load');
    await element.ready;
    expect(element.scene?.name).to.equal('first');
    element.src = addressOf(named('second'));
    await element.ready;
    expect(element.scene?.name).to.equal('second');
    expect(loads.count).to.equal(2);
  });

  it('takes an assigned object, text or parsed scene before all else', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    for (const scene of [{ name: 'object' }, '{ "name": "text" }', parseScene({ name: 'parsed' })]) {
      element.scene = scene;
      await element.ready;
      expect(element.scene).to.deep.equal(parseScene(scene));
    }
    element.src = addressOf(named('address'));
    await element.ready;
    expect(element.scene?.name).to.equal('parsed');
    partOf(element, 'ray-sphere').remove();
    element.scene = null;
    await element.ready;
    expect(element.scene?.name).to.equal('address');
  });

  it('tells where in an assigned scene something is wrong', async () => {
    const quiet = new QuietConsole();
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    element.scene = { objects: [{ type: 'sphere', radius: 0 }] };
    const error = (await rejection(element.ready)) as SceneError;
    expect(error.problems).to.deep.equal([
      { path: ['objects', 0, 'radius'], where: 'objects[0]', message: 'radius must be a number above 0, not 0' },
    ]);
    quiet.restore();
  });

  it('lets its own background go first', async () => {
    const element = await sceneWith(inline('any'), 'background="#fff"');
    await element.ready;
    expect(element.scene?.background).to.deep.equal([1, 1, 1]);
    element.background = 'transparent';
    await element.ready;
    expect(element.scene?.background).to.equal('transparent');
    element.background = null;
    await element.ready;
    expect(element.scene?.background).to.equal(undefined);
  });

  describe('with answers that take their time', () => {
    const original = window.fetch;
    let answers: { url: string; init: RequestInit | undefined; answer: (text: string) => void }[];
    beforeEach(() => {
      answers = [];
      window.fetch = (input, init) =>
        new Promise((resolve, reject) => {
          init?.signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
          answers.push({ url: String(input), init, answer: (text) => resolve(new Response(text)) });
        });
    });
    afterEach(() => {
      window.fetch = original;
    });

    it('aborts what is replaced, and ignores its answer', async () => {
      const quiet = new QuietConsole();
      const element = await sceneWith('', 'src="first.json"');
      await until(() => answers.length === 1);
      element.src = 'second.json';
      await until(() => answers.length === 2);
      expect(answers[0]?.init?.signal?.aborted).to.equal(true);
      answers[1]?.answer(named('second'));
      answers[0]?.answer(named('first'));
      await element.ready;
      await someFrames();
      expect(element.scene?.name).to.equal('second');
      expect(quiet.lines).to.deep.equal([]);
      quiet.restore();
    });

    it('gives up an address when a scene is assigned', async () => {
      const element = await sceneWith('', 'src="first.json"');
      await until(() => answers.length === 1);
      element.scene = { name: 'assigned' };
      await element.ready;
      expect(answers[0]?.init?.signal?.aborted).to.equal(true);
      expect(element.scene).to.include({ name: 'assigned' });
    });

    it('sends cookies to other origins only when told to', async () => {
      const element = await sceneWith('', 'src="https://example.org/scene.json"');
      await until(() => answers.length === 1);
      expect(answers[0]?.init?.credentials).to.equal('same-origin');
      element.setAttribute('crossorigin', 'use-credentials');
      await until(() => answers.length === 2);
      expect(answers[1]?.init?.credentials).to.equal('include');
    });

    it('loads nothing lazily before it is seen', async () => {
      const element = await sceneWith('', 'src="lazy.json" loading="lazy" hidden');
      await someFrames(5);
      expect(answers).to.have.lengthOf(0);
      element.hidden = false;
      await until(() => answers.length === 1);
      expect(answers[0]?.url).to.equal(new URL('lazy.json', document.baseURI).href);
    });

    it('keeps the picture until the next scene is there', async () => {
      const element = await sceneWith('<ray-sphere></ray-sphere>');
      await element.complete;
      element.replaceChildren();
      element.src = 'late.json';
      let isReady = false;
      element.ready.then(() => {
        isReady = true;
      });
      await until(() => answers.length === 1);
      await someFrames(5);
      expect(isReady).to.equal(false);
      expect(element.scene?.objects).to.have.lengthOf(1);
      answers[0]?.answer(named('late'));
      await oneEvent(element, 'load');
      expect(element.scene?.name).to.equal('late');
    });
  });
});
