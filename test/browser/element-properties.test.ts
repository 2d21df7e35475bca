import { expect } from '@open-wc/testing';
import {
  RaySceneCompleteEvent,
  RaySceneErrorEvent,
  type RaySceneIntrinsicElements,
  RaySceneProgressEvent,
} from '../../packages/ray-scene/src/index.ts';
import { countEvents, partOf, sceneWith, someFrames } from './element-fixtures.ts';

describe('properties of scene elements', () => {
  it('are read through the table, whatever was given', () => {
    const sphere = document.createElement('ray-sphere');
    expect(sphere.center).to.deep.equal([0, 0, 0]);
    sphere.setAttribute('center', '1, 2 3');
    expect(sphere.center).to.deep.equal([1, 2, 3]);
    expect(Object.isFrozen(sphere.center)).to.equal(true);
    sphere.setAttribute('radius', 'big');
    expect(sphere.radius).to.equal(1);
    Object.assign(sphere, { radius: '2.5' });
    expect(sphere.radius).to.equal(2.5);
    sphere.removeAttribute('radius');
    expect(sphere.radius).to.equal(1);
  });

  it('are copies of arrays, and cannot change the defaults', () => {
    const sphere = document.createElement('ray-sphere');
    const center: [number, number, number] = [1, 2, 3];
    sphere.center = center;
    center[0] = 9;
    expect(sphere.center).to.deep.equal([1, 2, 3]);
    sphere.removeAttribute('center');
    expect(() => Object.assign(document.createElement('ray-sphere').center, [9])).to.throw();
    expect(document.createElement('ray-sphere').center).to.deep.equal([0, 0, 0]);
  });

  it('leave the attributes alone, but for choices', () => {
    const light = document.createElement('ray-light');
    light.intensity = 5;
    expect(light.hasAttribute('intensity')).to.equal(false);
    light.type = 'directional';
    expect(light.getAttribute('type')).to.equal('directional');
    light.decay = 0;
    expect(light.getAttribute('decay')).to.equal('0');
    expect(light.decay).to.equal(0);
  });

  it('of a light are those of its type', () => {
    const light = document.createElement('ray-light');
    expect(light.type).to.equal('point');
    expect(light.position).to.deep.equal([0, 1, 0]);
    light.type = 'directional';
    expect(light.position).to.equal(undefined);
  });

  it('of a surface are open on an object, which may have a material', () => {
    const sphere = document.createElement('ray-sphere');
    expect(sphere.roughness).to.equal(undefined);
    sphere.roughness = 0.1;
    expect(sphere.roughness).to.equal(0.1);
  });

  it('may be set before the class is known', async () => {
    const host = document.createElement('div');
    const late = document.implementation.createHTMLDocument().createElement('ray-sphere');
    Object.assign(late, { radius: 3 });
    late.setAttribute('radius', '2');
    host.append(late);
    document.body.append(host);
    expect(late).to.have.property('radius', 3);
    host.remove();
  });

  it('have names and types in JSX', () => {
    const sphere: RaySceneIntrinsicElements['ray-sphere'] = { radius: '2', 'checker-size': 1, 'data-x': 1, id: 'ball' };
    const scene: RaySceneIntrinsicElements['ray-scene'] = { toneMapping: 'none', 'camera-controls': true, alt: 'Ball' };
    // @ts-expect-error: no such attribute
    const wrong: RaySceneIntrinsicElements['ray-plane'] = { raduis: 1 };
    expect([sphere, scene, wrong]).to.have.lengthOf(3);
  });

  it('and events have types', () => {
    const element = document.createElement('ray-scene');
    const told: string[] = [];
    element.addEventListener('error', ({ error, problems }) =>
      told.push(error.message, ...problems.map(({ where }) => where)),
    );
    element.addEventListener('progress', ({ samples, total }) => told.push(`${samples} of ${total}`));
    element.dispatchEvent(new RaySceneErrorEvent(new Error('broken')));
    element.addEventListener('complete', ({ reason, error }) => told.push(`${reason} at ${error}`));
    element.dispatchEvent(new RaySceneProgressEvent('progress', 1, 2));
    element.dispatchEvent(new RaySceneCompleteEvent(2, 2, 'samples', 0.5));
    expect(told).to.deep.equal(['broken', '1 of 2', 'samples at 0.5']);
  });
});

describe('properties of <ray-scene>', () => {
  it('are its settings, as attributes too', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>', 'tone-mapping="none" exposure="2"');
    expect(element.toneMapping).to.equal('none');
    expect(element.exposure).to.equal(2);
    expect(element.samples).to.equal(2);
    expect(element.pixelRatio).to.equal(1);
    element.exposure = 3;
    expect(element.getAttribute('exposure')).to.equal('2');
    element.toneMapping = 'neutral';
    expect(element.getAttribute('tone-mapping')).to.equal('neutral');
    expect(element.settings).to.include({ exposure: 3, toneMapping: 'neutral', samples: 2, bounces: 6 });
  });

  it('are those of a quality unless they are given themselves', async () => {
    const element = document.createElement('ray-scene');
    expect(element.settings).to.include({ quality: 'balanced', samples: 256 });
    expect(element.settings).to.not.have.property('maxError');
    element.quality = 'accurate';
    expect(element.settings).to.include({ samples: 1024, maxError: 0.01, bounces: 16 });
    element.maxError = 0.05;
    expect(element.settings).to.include({ samples: 1024, maxError: 0.05 });
    element.setAttribute('quality', 'draft');
    expect(element.settings).to.include({ integrator: 'direct', bounces: 4, samples: 4 });
    element.integrator = 'path';
    expect(element.settings).to.include({ integrator: 'path', bounces: 4, samples: 4 });
  });

  it('reflect if they are flags or choices', async () => {
    const element = await sceneWith('');
    expect(element.loading).to.equal('eager');
    expect(element.hasAttribute('loading')).to.equal(false);
    Object.assign(element, {
      cameraControls: true,
      autoRotate: true,
      paused: true,
      loading: 'lazy',
      src: 'x',
      alt: 'y',
    });
    await element.updateComplete;
    expect(element.getAttributeNames()).to.include.members(['camera-controls', 'auto-rotate', 'paused', 'loading']);
    expect(element.getAttributeNames()).to.not.include.members(['src']);
    expect(element.getAttributeNames()).to.not.include.members(['alt']);
  });

  it('may be set before the class is known', async () => {
    const late = document.implementation.createHTMLDocument().createElement('ray-scene');
    Object.assign(late, { samples: 3, cameraControls: true, scene: { name: 'early' } });
    document.body.append(late);
    await late.ready;
    expect(late.scene?.name).to.equal('early');
    expect(late.settings.samples).to.equal(3);
    expect(late.hasAttribute('camera-controls')).to.equal(true);
    late.remove();
  });

  it('batch edits into one change per frame', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await element.complete;
    const completes = countEvents(element, 'complete');
    const sphere = partOf(element, 'ray-sphere');
    const plane = document.createElement('ray-plane');
    for (let i = 1; i <= 100; i++) {
      sphere.radius = i;
      sphere.setAttribute('center', `${i} 0 0`);
      if (i === 50) element.append(plane);
    }
    await element.complete;
    await someFrames();
    expect(completes.count).to.equal(1);
    expect(element.scene?.objects[0]).to.include({ radius: 100 });
    expect(element.scene?.objects).to.have.lengthOf(2);
  });

  it('keep the samples when nothing has really changed', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await element.complete;
    const progress = countEvents(element, 'progress');
    partOf(element, 'ray-sphere').radius = 1;
    element.classList.toggle('selected');
    await element.complete;
    await someFrames();
    expect(progress.count).to.equal(0);
  });

  it('compile nothing when numbers change', async () => {
    const element = await sceneWith('<ray-sphere></ray-sphere>');
    await element.complete;
    const compiles = element.stats?.compiles;
    partOf(element, 'ray-sphere').radius = 2;
    partOf(element, 'ray-sphere').center = [1, 0, 0];
    element.exposure = 2;
    await element.complete;
    expect(element.stats?.compiles).to.equal(compiles);
  });
});
