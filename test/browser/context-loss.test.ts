import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings } from '@ray-scene/core';
import { QuarantineError, RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';
import { loseAndRestore } from './gl-fixtures.ts';

// Opaque: how a canvas rounds what is transparent when it is read depends on where it keeps it just then.
const ball = parseScene({
  background: 'navy',
  objects: [{ type: 'sphere', color: 'crimson' }],
  lights: [{ type: 'directional' }],
});
const plane = parseScene({ objects: [{ type: 'plane', color: 'crimson' }], lights: [{ type: 'directional' }] });

describe('loss of the context', () => {
  let device: RenderDevice;
  let renderers: Renderer[];

  beforeEach(() => {
    device = new RenderDevice();
    renderers = [];
  });
  afterEach(() => {
    for (const renderer of renderers) renderer.dispose();
    device.dispose();
  });

  function make(canvas = document.createElement('canvas')): {
    renderer: Renderer;
    errors: Error[];
    restored: () => number;
  } {
    const renderer = new Renderer(canvas, device);
    renderers.push(renderer);
    const errors: Error[] = [];
    let restored = 0;
    renderer.onerror = (error) => errors.push(error);
    renderer.onrestored = () => restored++;
    renderer.resize(8, 8);
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 3 }));
    renderer.setScene(ball);
    return { renderer, errors, restored: () => restored };
  }

  const complete = (renderer: Renderer): void => {
    while (renderer.draw(1));
  };

  /** Until the device has seen all work finished, so that nobody is at work when the context is lost. */
  const idle = async (): Promise<void> => {
    while (device.clock.busyWith) await new Promise((resolve) => setTimeout(resolve, 1));
  };

  it('leaves the last picture in place and brings the same one back', async () => {
    const canvas = document.createElement('canvas');
    const pixels = () => (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, 8, 8).data;
    const { renderer, errors, restored } = make(canvas);
    complete(renderer);
    await idle();
    const [before, radiance] = [pixels(), renderer.readRadiance()];
    expect(before.some((value) => value > 0)).to.equal(true);
    await loseAndRestore(device.gl, () => {
      expect(pixels()).to.deep.equal(before);
      expect(renderer.draw(10)).to.equal(false);
      expect(renderer.samples).to.equal(0);
      expect(renderer.readRadiance().every((value) => value === 0)).to.equal(true);
    });
    expect(restored()).to.equal(1);
    expect(renderer.draw(1)).to.equal(true);
    complete(renderer);
    expect(renderer.readRadiance()).to.deep.equal(radiance);
    expect(pixels()).to.deep.equal(before);
    expect(errors).to.deep.equal([]);
  });

  it('may come at any moment: between two draws, and before the event', () => {
    const { renderer, errors } = make();
    renderer.draw(1);
    device.gl.getExtension('WEBGL_lose_context')?.loseContext();
    expect(renderer.draw(1)).to.equal(false);
    renderer.setScene(plane);
    renderer.resize(4, 4);
    expect(renderer.draw(1)).to.equal(false);
    expect(errors).to.deep.equal([]);
  });

  it('takes what is set meanwhile', async () => {
    const { renderer } = make();
    complete(renderer);
    await idle();
    await loseAndRestore(device.gl, () => {
      renderer.setScene(plane);
      renderer.resize(5, 3);
    });
    complete(renderer);
    expect(renderer.samples).to.equal(3);
    expect(renderer.readRadiance().length).to.equal(5 * 3 * 4);
  });

  it('puts a scene in quarantine that loses it twice, and no other', async () => {
    const bad = make();
    const good = make();
    for (let loss = 0; loss < 2; loss++) {
      complete(good.renderer);
      await idle();
      expect(bad.renderer.draw(0)).to.equal(true);
      await loseAndRestore(device.gl);
    }
    expect(bad.errors.length).to.equal(1);
    expect(bad.errors[0]).to.be.instanceOf(QuarantineError);
    expect(bad.renderer.draw(1)).to.equal(false);
    expect(good.errors).to.deep.equal([]);
    complete(good.renderer);
    expect(good.renderer.samples).to.equal(3);
    // The same with other numbers stays where it is; another scene is given a chance.
    bad.renderer.setScene(parseScene({ ...ball, objects: [{ type: 'sphere', radius: 2 }] }));
    expect(bad.renderer.draw(1)).to.equal(false);
    bad.renderer.setScene(plane);
    complete(bad.renderer);
    expect(bad.renderer.samples).to.equal(3);
  });

  it('is nobody’s fault when nobody is at work', async () => {
    const { renderer, errors } = make();
    for (let loss = 0; loss < 3; loss++) {
      complete(renderer);
      await idle();
      await loseAndRestore(device.gl);
    }
    expect(errors).to.deep.equal([]);
  });
});
