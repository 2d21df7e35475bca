import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings } from '@ray-scene/core';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';

const ballOnPlane = parseScene({
  background: 'navy',
  objects: [
    { type: 'sphere', color: 'crimson' },
    { type: 'plane', point: [0, -1, 0] },
  ],
  lights: [{ type: 'directional', direction: [-1, -2, -3] }],
});

describe('a picture that takes longer than a frame', () => {
  let device: RenderDevice;
  let renderer: Renderer;
  let canvas: HTMLCanvasElement;

  beforeEach(() => {
    device = new RenderDevice();
    canvas = document.createElement('canvas');
    renderer = new Renderer(canvas, device);
    renderer.onerror = (error) => {
      throw error;
    };
    // A GPU that takes ten frames for a sample of 256 × 256 pixels.
    const { gl } = device;
    let pixels = 0;
    const { drawArrays } = gl;
    gl.drawArrays = (...args) => {
      const [, , width = 0, height = 0] = gl.getParameter(gl.SCISSOR_TEST)
        ? gl.getParameter(gl.SCISSOR_BOX)
        : gl.getParameter(gl.VIEWPORT);
      pixels += gl.getParameter(gl.FRAMEBUFFER_BINDING) ? width * height : 0;
      drawArrays.apply(gl, args);
    };
    device.clock.endBatch = (_owner, done) => {
      done((100 * pixels) / 256 ** 2);
      most = Math.max(most, pixels);
      pixels = 0;
    };
    most = 0;
    renderer.resize(256, 256);
    renderer.setSettings(parseSettings({ samples: 2 }));
    renderer.setScene(ballOnPlane);
    while (renderer.samples < 1) renderer.draw(10);
    most = 0;
  });
  afterEach(() => {
    renderer.dispose();
    device.dispose();
  });

  /** Pixels that were traced in one frame, at most. */
  let most: number;

  const turned = (x: number) => ({ ...renderer.camera, position: [x, 1, 5] as const });

  function brightness(): number {
    const { width, height } = canvas;
    const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, width, height);
    return data.reduce((sum, value) => sum + value, 0) / data.length;
  }

  it('is drawn tile by tile within the time of a frame, and comes to the same', () => {
    while (renderer.draw(10));
    expect(renderer.samples).to.equal(2);
    expect(most).to.be.within(1, 256 ** 2 / 10);
    const tiled = renderer.readRadiance();
    const other = new Renderer(document.createElement('canvas'), device);
    other.resize(256, 256);
    other.setSettings(parseSettings({ samples: 2 }));
    other.setScene(ballOnPlane);
    while (other.draw(1000));
    expect(other.readRadiance()).to.deep.equal(tiled);
    other.dispose();
  });

  it('is shown smaller while the camera moves, and whole when it rests', () => {
    for (let i = 0; i < 5; i++) {
      renderer.setCamera(turned(i / 10));
      expect(renderer.draw(10)).to.equal(true);
      expect(canvas.width).to.equal(64);
      expect(most).to.be.at.most(256 ** 2 / 10);
    }
    const moving = brightness();
    while (renderer.samples < 1) renderer.draw(10);
    expect(canvas.width).to.equal(256);
    expect(brightness() / moving).to.be.closeTo(1, 0.02);
    expect(most).to.be.at.most(256 ** 2 / 10);
  });

  it('becomes finer at rest until it is whole, within the time of a frame', () => {
    renderer.setCamera(turned(1));
    const widths = new Set<number>();
    while (renderer.samples < 1) {
      renderer.draw(10);
      widths.add(canvas.width);
    }
    expect([...widths]).to.deep.equal([64, 128, 256]);
    expect(most).to.be.at.most(256 ** 2 / 10);
  });

  it('shows something with the first draw, however slow the GPU may be', () => {
    const first = new Renderer(canvas, device);
    first.resize(1000, 1000);
    first.setScene(ballOnPlane);
    first.draw(1);
    expect(first.isShown).to.equal(true);
    expect(canvas.width).to.be.within(64, 256);
    first.dispose();
  });

  it('is drawn at once only where a frame has time for that', () => {
    renderer.setCamera(turned(1));
    renderer.draw(90);
    expect(most).to.be.at.most(0.9 * 256 ** 2);
    renderer.setCamera(turned(2));
    renderer.draw(130);
    expect(renderer.samples).to.equal(1);
    expect(canvas.width).to.equal(256);
  });
});
