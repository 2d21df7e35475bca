import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, type Scene } from '@ray-scene/core';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';
import { countObjects, fillSource } from './gl-fixtures.ts';

const light = { type: 'directional', direction: [-1, -2, -3] };
// Opaque: how a canvas rounds what is transparent when it is read depends on where it keeps it just then.
const background = 'navy';
const ball = parseScene({ background, objects: [{ type: 'sphere', color: 'crimson' }], lights: [light] });
const ballOnPlane = parseScene({
  background,
  objects: [
    { type: 'sphere', color: 'crimson' },
    { type: 'plane', point: [0, -1, 0] },
  ],
  lights: [light],
});

const settings = parseSettings({ integrator: 'direct', samples: 4 });

/** Draws until the picture is complete. */
function complete(renderer: Renderer): void {
  while (renderer.draw(1));
}

describe('Renderer', () => {
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

  function make(scene: Scene | undefined, size = 8, canvas = document.createElement('canvas')): Renderer {
    const renderer = new Renderer(canvas, device);
    renderers.push(renderer);
    renderer.onerror = (error) => {
      throw error;
    };
    renderer.resize(size, size);
    renderer.setSettings(settings);
    if (scene) renderer.setScene(scene);
    return renderer;
  }

  const pixels = (canvas: HTMLCanvasElement): Uint8ClampedArray =>
    (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, canvas.width, canvas.height).data;

  it('draws nothing before it has a scene', () => {
    const renderer = make(undefined);
    expect(renderer.draw(10)).to.equal(false);
    expect(device.compileCount).to.equal(0);
  });

  it('adds samples, at least one a time, until it has all of them', () => {
    const renderer = make(ball);
    expect(renderer.samples).to.equal(0);
    expect(renderer.draw(0)).to.equal(true);
    expect(renderer.samples).to.equal(1);
    complete(renderer);
    expect(renderer.samples).to.equal(4);
    expect(renderer.draw(10)).to.equal(false);
    expect(renderer.samples).to.equal(4);
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 6 }));
    expect(renderer.samples).to.equal(4);
    complete(renderer);
    expect(renderer.samples).to.equal(6);
    renderer.setScene(ball);
    expect(renderer.samples).to.equal(0);
  });

  it('shows what it computed, the right way up, transparent where nothing is', () => {
    const canvas = document.createElement('canvas');
    const scene = parseScene({
      camera: { position: [0, 0, 10], fov: 40 },
      objects: [{ type: 'sphere', center: [0, 2, 0], color: [0.5, 0.2, 0.1] }],
      lights: [{ type: 'directional', direction: [0, 0, -1], intensity: 3 }],
    });
    const renderer = make(scene, 32, canvas);
    complete(renderer);
    const radiance = renderer.readRadiance();
    const shown = pixels(canvas);
    const at = (data: ArrayLike<number>, x: number, y: number) =>
      Array.from({ length: 4 }, (_, i) => data[4 * (32 * y + x) + i] as number);
    // The ball is in the upper half; row 0 is the top one.
    expect(at(radiance, 16, 7)[3]).to.equal(1);
    expect(at(radiance, 16, 7)[0]).to.be.greaterThan(at(radiance, 16, 7)[1] as number);
    expect(at(shown, 16, 7)[3]).to.equal(255);
    expect(at(shown, 16, 7)[0]).to.be.greaterThan(at(shown, 16, 7)[1] as number);
    expect(at(radiance, 16, 28)).to.deep.equal([0, 0, 0, 0]);
    expect(at(shown, 16, 28)).to.deep.equal([0, 0, 0, 0]);
    expect(radiance.every(Number.isFinite)).to.equal(true);
    // Premultiplied: along the edge, light and coverage fall together.
    const edge = Array.from({ length: 32 * 32 }, (_, i) => radiance[4 * i + 3] as number).filter((a) => a > 0 && a < 1);
    expect(edge.length).to.be.greaterThan(0);
  });

  it('shows another exposure without another sample', () => {
    const canvas = document.createElement('canvas');
    const renderer = make(ball, 8, canvas);
    complete(renderer);
    const radiance = renderer.readRadiance();
    expect(pixels(canvas).some((value, i) => i % 4 < 3 && value > 0)).to.equal(true);
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 4, exposure: 0 }));
    expect(renderer.draw(10)).to.equal(false);
    expect(renderer.readRadiance()).to.deep.equal(radiance);
    expect(pixels(canvas).some((value, i) => i % 4 < 3 && value > 0)).to.equal(false);
  });

  it('keeps the old picture until it has one of the new size', () => {
    const canvas = document.createElement('canvas');
    const renderer = make(ball, 8, canvas);
    complete(renderer);
    const before = pixels(canvas);
    renderer.resize(16, 4);
    expect(pixels(canvas)).to.deep.equal(before);
    renderer.draw(10);
    expect([canvas.width, canvas.height]).to.deep.equal([16, 4]);
    expect(renderer.readRadiance().length).to.equal(16 * 4 * 4);
    expect(renderer.stats).to.include({ width: 16, height: 4, precision: 'float' });
  });

  it('shrinks a picture that the GPU cannot draw', () => {
    const renderer = make(ball);
    renderer.resize(4 * device.maxSize, 8);
    expect(renderer.stats).to.include({ width: device.maxSize, height: 2 });
  });

  it('frames the objects, follows the shape of the picture, but not objects that move', () => {
    const renderer = make(ball);
    const framed = renderer.camera;
    renderer.setScene(parseScene({ objects: [{ type: 'sphere', center: [0, 1, 0], radius: 3 }], lights: [light] }));
    expect(renderer.camera).to.deep.equal(framed);
    renderer.resize(4, 8);
    const distance = ({ position, target }: Renderer['camera']) =>
      Math.hypot(...position.map((x, i) => x - (target[i] as number)));
    expect(distance(renderer.camera)).to.be.greaterThan(distance(framed));
    renderer.resize(8, 8);
    expect(renderer.camera).to.deep.equal(framed);
    renderer.setScene(parseScene({ objects: [{ type: 'sphere', name: 'other', radius: 3 }] }));
    expect(renderer.camera).not.to.deep.equal(framed);
  });

  it('takes the camera of the controls before the author’s', () => {
    const renderer = make(parseScene({ camera: { position: [0, 0, 9] }, objects: [{ type: 'sphere' }] }));
    expect(renderer.camera.position).to.deep.equal([0, 0, 9]);
    complete(renderer);
    const own = { ...renderer.camera, position: [0, 3, 9] } as const;
    renderer.setCamera(own);
    expect(renderer.camera).to.deep.equal(own);
    expect(renderer.samples).to.equal(0);
    complete(renderer);
    renderer.setCamera({ ...own });
    expect(renderer.samples, 'the same camera again').to.equal(4);
    renderer.setCamera(undefined);
    expect(renderer.camera.position).to.deep.equal([0, 0, 9]);
  });

  it('draws the same in half floats, as far as they go', () => {
    const renderer = make(ball);
    complete(renderer);
    const full = renderer.readRadiance();
    const halfDevice = new RenderDevice({ precision: 'half' });
    const other = new Renderer(document.createElement('canvas'), halfDevice);
    other.resize(8, 8);
    other.setSettings(settings);
    other.setScene(ball);
    complete(other);
    expect(other.stats.precision).to.equal('half');
    for (const [i, value] of other.readRadiance().entries()) {
      const reference = full[i] as number;
      // Each of the four samples may round once.
      expect(value).to.be.closeTo(reference, 4 * 2 ** -11 * reference + 2 ** -24);
    }
    other.dispose();
    halfDevice.dispose();
  });

  it('estimates the time of a sample', async () => {
    const renderer = make(ball);
    expect(renderer.stats.msPerSample).to.equal(0);
    complete(renderer);
    while (renderer.stats.msPerSample === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    expect(renderer.stats.msPerSample).to.be.greaterThan(0);
    expect(renderer.stats.compileMs).to.be.greaterThan(0);
  });

  it('reports an error once, and draws again when its cause is gone', () => {
    const renderer = make(ball);
    const { gl } = device;
    const errors: Error[] = [];
    renderer.onerror = (error) => errors.push(error);
    const { checkFramebufferStatus } = gl;
    gl.checkFramebufferStatus = () => gl.FRAMEBUFFER_UNSUPPORTED;
    expect(renderer.draw(1)).to.equal(false);
    expect(renderer.draw(1)).to.equal(false);
    renderer.setScene(ball);
    expect(renderer.draw(1)).to.equal(false);
    expect(errors.map(({ message }) => message)).to.deep.equal([
      'A picture of 8 × 8 pixels does not fit into the graphics memory',
    ]);
    gl.checkFramebufferStatus = checkFramebufferStatus;
    renderer.setScene(ball);
    expect(renderer.draw(1)).to.equal(true);
  });

  it('frees all it made when it is disposed of', () => {
    const counts = countObjects(device.gl);
    const some = [make(ball), make(ballOnPlane), make(ball, 16)];
    for (const renderer of some) {
      complete(renderer);
      renderer.setScene(ballOnPlane);
      renderer.resize(5, 9);
      complete(renderer);
      renderer.dispose();
      expect(renderer.draw(1)).to.equal(false);
    }
    expect(counts).to.include({ Buffer: 0, Framebuffer: 0, Texture: 0 });
    // Some programs stay for views to come, until there are younger ones.
    for (let i = 0; i < 8; i++) device.programs.release(`${i}`, device.programs.acquire(`${i}`, fillSource('vec4(1)')));
    expect(counts.Program).to.equal(8);
    device.dispose();
    expect(counts).to.include({ Program: 0, Shader: 0 });
  });

  it('draws twenty views with one context', () => {
    const canvases = Array.from({ length: 20 }, () => document.createElement('canvas'));
    const contexts: unknown[] = [];
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...args: Parameters<typeof getContext>
    ) {
      const context = getContext.apply(this, args);
      if (args[0] === 'webgl2') contexts.push(context);
      return context;
    } as typeof getContext;
    const many = canvases.map((canvas) => new Renderer(canvas));
    for (const renderer of many) {
      renderer.resize(6, 6);
      renderer.setSettings(parseSettings({ integrator: 'direct', samples: 2 }));
      renderer.setScene(ball);
      complete(renderer);
    }
    HTMLCanvasElement.prototype.getContext = getContext;
    expect(contexts.length).to.equal(1);
    // The tracing program and the display program.
    expect(RenderDevice.shared.compileCount).to.equal(2);
    const [first, ...others] = canvases.map(pixels);
    expect(first?.some((value) => value > 0)).to.equal(true);
    for (const other of others) expect(other).to.deep.equal(first);
    for (const renderer of many) renderer.dispose();
    RenderDevice.shared.dispose();
  });
});
