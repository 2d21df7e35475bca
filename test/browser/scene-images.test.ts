// Images that a scene names: they are asked for once, waited for, and what is wrong with them is told.
import '@ray-scene/core/parts';
import { expect, oneEvent } from '@open-wc/testing';
import { readRadianceImage, SceneError } from '@ray-scene/core';
import { relativeDifference, renderReference } from '@ray-scene/core/reference';
import { inPieces } from '../../packages/ray-scene/src/in-pieces.ts';
import type { RayScene, RaySceneErrorEvent } from '../../packages/ray-scene/src/index.ts';
import {
  countEvents,
  overlayOf,
  partOf,
  QuietConsole,
  rejection,
  sceneWith,
  someFrames,
  until,
} from './element-fixtures.ts';

const WINDOW = new URL('../../examples/images/window.hdr', import.meta.url).href;
const ball = '<ray-sphere></ray-sphere>';
const litBy = (src: string): string => `<ray-environment src="${src}"></ray-environment>${ball}`;

/** An image of one colour: 2 × 1 pixels whose mantissas are (n, n, n), in steps of 1/256. */
const plain = (n: number): Uint8Array<ArrayBuffer> =>
  new Uint8Array([...new TextEncoder().encode('#?RADIANCE\n\n-Y 1 +X 2\n'), n, n, n, 128, n, n, n, 128]);

/** The red of the pixel in the upper left corner, where nothing but the surroundings is seen. */
const cornerOf = (element: RayScene): number => element.readRadiance()[0] as number;

describe('images of <ray-scene>', () => {
  it('light the scene as they do in the reference', async () => {
    const element = await sceneWith(litBy(WINDOW), 'samples="2" integrator="path"');
    await element.complete;
    const image = readRadianceImage(new Uint8Array(await (await fetch(WINDOW)).arrayBuffer()));
    const reference = renderReference(element.scene as NonNullable<RayScene['scene']>, {
      width: 60,
      height: 40,
      samples: 2,
      integrator: 'path',
      images: new Map([[WINDOW, image]]),
    });
    const off = relativeDifference(element.readRadiance(), reference).filter((value) => !(value <= 1e-3)).length;
    expect(off / (60 * 40), 'share of pixels off by more than 1e-3').to.be.below(0.005);
  });

  it('are read in pieces, between which the page goes on', async () => {
    const rows = 20;
    let read = 0;
    function* slowly(): Generator<undefined, string> {
      for (; read < rows; read++) {
        const end = performance.now() + 2;
        while (performance.now() < end);
        yield;
      }
      return 'all';
    }
    const seen: number[] = [];
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      seen.push(read);
      port2.postMessage(undefined);
    };
    port2.postMessage(undefined);
    expect(await inPieces(slowly())).to.equal('all');
    port1.close();
    expect(seen.some((count) => count > 0 && count < rows)).to.equal(true);
  });

  describe('with answers of our own', () => {
    const original = window.fetch;
    let asked: { url: string; init: RequestInit | undefined; answer: (body: BodyInit, status?: number) => void }[];
    let quiet: QuietConsole;
    beforeEach(() => {
      asked = [];
      quiet = new QuietConsole();
      window.fetch = (input, init) =>
        new Promise((resolve, reject) => {
          init?.signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
          const answer = (body: BodyInit, status = 200): void =>
            resolve(new Response(body, { status, statusText: status === 404 ? 'Not Found' : '' }));
          asked.push({ url: String(input), init, answer });
        });
    });
    afterEach(() => {
      window.fetch = original;
      quiet.restore();
    });

    const request = async (number: number) => {
      await until(() => asked.length > number);
      return asked[number] as (typeof asked)[number];
    };

    it('are waited for, relative to the page', async () => {
      const element = await sceneWith(litBy('sky.hdr'));
      const loads = countEvents(element, 'load');
      let isReady = false;
      element.ready.then(() => {
        isReady = true;
      });
      const { url, answer } = await request(0);
      await someFrames(5);
      expect([isReady, loads.count, url]).to.deep.equal([false, 0, new URL('sky.hdr', document.baseURI).href]);
      answer(plain(127));
      await element.complete;
      expect(loads.count).to.equal(1);
      expect(cornerOf(element)).to.equal(127.5 / 256);
    });

    it('are relative to the file of the scene', async () => {
      const element = await sceneWith('', 'src="some/where/scene.json"');
      const scene = { environment: { src: 'skies/a.hdr' }, objects: [{ type: 'sphere' }] };
      (await request(0)).answer(JSON.stringify(scene));
      const { url, answer } = await request(1);
      expect(url).to.equal(new URL('some/where/skies/a.hdr', document.baseURI).href);
      answer(plain(63));
      await element.complete;
      expect(cornerOf(element)).to.equal(63.5 / 256);
      // The same words in another place are another image.
      element.src = 'else/where/scene.json';
      (await request(2)).answer(JSON.stringify(scene));
      (await request(3)).answer(plain(31));
      await element.complete;
      expect(cornerOf(element)).to.equal(31.5 / 256);
    });

    it('are asked for once, whatever else is edited', async () => {
      const element = await sceneWith(litBy('sky.hdr'));
      (await request(0)).answer(plain(127));
      await element.ready;
      partOf(element, 'ray-sphere').radius = 0.5;
      await element.ready;
      partOf(element, 'ray-environment').intensity = 2;
      await element.complete;
      expect(cornerOf(element)).to.equal(127.5 / 128);
      expect(asked).to.have.lengthOf(1);
    });

    it('are no business of scenes without one', async () => {
      const element = await sceneWith('<ray-environment color="white"></ray-environment><ray-sphere></ray-sphere>');
      await element.complete;
      expect(asked).to.deep.equal([]);
    });

    it('keep the last good picture until they are there, and if they do not come', async () => {
      const element = await sceneWith(litBy('first.hdr'));
      const first = await request(0);
      first.answer(plain(127));
      await element.complete;
      partOf(element, 'ray-environment').setAttribute('src', 'second.hdr');
      const errors = countEvents(element, 'error');
      const { url, answer } = await request(1);
      await someFrames();
      expect(element.scene?.environment?.src).to.equal('first.hdr');
      answer('', 404);
      const error = (await rejection(element.ready)) as SceneError;
      expect(error).to.be.instanceOf(SceneError);
      const message = `src must be the address of a Radiance .hdr image, not "second.hdr": ${url} could not be loaded: 404 Not Found`;
      expect(error.problems).to.deep.equal([{ path: ['environment'], where: 'ray-scene > ray-environment', message }]);
      expect(errors.count).to.equal(1);
      expect(cornerOf(element)).to.equal(127.5 / 256);
      await element.updateComplete;
      expect(overlayOf(element)).to.equal(`ray-scene > ray-environment: ${message}`);
      // Mended, it is drawn.
      partOf(element, 'ray-environment').setAttribute('src', 'third.hdr');
      (await request(2)).answer(plain(31));
      await element.complete;
      expect(cornerOf(element)).to.equal(31.5 / 256);
      expect(overlayOf(element)).to.equal(undefined);
    });

    it('tell what they are if they are none', async () => {
      const element = await sceneWith('');
      element.scene = { environment: { src: 'cat.gif' } };
      const { url, answer } = await request(0);
      answer('GIF89a\n');
      const { error } = await oneEvent<RaySceneErrorEvent>(element, 'error');
      expect(error.message).to.equal(
        `environment: src must be the address of a Radiance .hdr image, not "cat.gif": ${url} could not be loaded: it does not begin with "#?"`,
      );
    });

    it('are given up when the scene wants them no more, or leaves the page', async () => {
      const element = await sceneWith(litBy('first.hdr'));
      const first = await request(0);
      partOf(element, 'ray-environment').setAttribute('src', 'second.hdr');
      const second = await request(1);
      expect(first.init?.signal?.aborted).to.equal(true);
      const { parentElement } = element;
      element.remove();
      expect(second.init?.signal?.aborted).to.equal(true);
      parentElement?.append(element);
      (await request(2)).answer(plain(127));
      await element.complete;
      expect(cornerOf(element)).to.equal(127.5 / 256);
      expect(quiet.lines).to.deep.equal([]);
    });

    it('take cookies along only when told to', async () => {
      const element = await sceneWith(litBy('https://example.org/sky.hdr'));
      expect((await request(0)).init?.credentials).to.equal('same-origin');
      element.setAttribute('crossorigin', 'use-credentials');
      expect((await request(1)).init?.credentials).to.equal('include');
    });
  });
});
