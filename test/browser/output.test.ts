import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, type Scene } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';

const camera = { position: [0, 0, 5], target: [0, 0, 0] };
const wall = { type: 'quad', corner: [-9, -9, -5], edgeU: [18, 0, 0], edgeV: [0, 18, 0], color: 'crimson' };
const ball = { type: 'sphere', color: 'gold', metalness: 1 };

const nextTask = (): Promise<unknown> => new Promise((done) => setTimeout(done));

describe('output', () => {
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
    renderer.resize(33, 33);
  });
  afterEach(() => {
    renderer.dispose();
    device.dispose();
  });

  async function show(scene: Scene, settings: object): Promise<void> {
    renderer.setScene(scene);
    // Neither light nor its exposure bears on it.
    renderer.setSettings(parseSettings({ samples: 4, exposure: 7, ...settings }));
    while (renderer.draw(5) || !renderer.stopped) await nextTask();
  }

  /** The bytes of a pixel, counted from the middle to the right and upwards. */
  const shownAt = (x: number, y: number): readonly number[] => [
    ...(canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(16 + x, 16 - y, 1, 1).data,
  ];

  const near = (found: readonly number[], expected: readonly number[], tolerance: number): void =>
    expected.forEach((byte, i) => {
      expect(found[i], `${found} for ${expected}`).to.be.within(byte - tolerance, byte + tolerance);
    });

  for (const integrator of ['path', 'direct']) {
    const scene = parseScene({ camera, objects: [ball, wall] });

    it(`normal, ${integrator}: 0.5 n + 0.5, towards the camera`, async () => {
      await show(scene, { integrator, output: 'normal' });
      // A pixel of the ball holds directions that differ by a few degrees.
      near(shownAt(0, 0), [128, 128, 255, 255], 3);
      near(shownAt(14, 14), [128, 128, 255, 255], 1);
      const [right = 0, up = 0] = shownAt(5, 0);
      expect(right).to.be.greaterThan(180);
      expect(up).to.be.within(124, 131);
    });

    it(`depth, ${integrator}: 1 / (1 + t / T)`, async () => {
      await show(scene, { integrator, output: 'depth' });
      const byte = 255 / (1 + 4 / 5);
      near(shownAt(0, 0), [byte, byte, byte, 255], 2);
    });

    it(`albedo, ${integrator}: the base colour, as it was written`, async () => {
      await show(scene, { integrator, output: 'albedo' });
      near(shownAt(0, 0), [255, 215, 0, 255], 1);
      near(shownAt(14, 14), [220, 20, 60, 255], 1);
    });
  }

  it('shows nothing where nothing is, whatever the background', async () => {
    await show(parseScene({ camera, background: 'navy', objects: [ball] }), { output: 'normal' });
    expect(shownAt(15, 15)).to.deep.equal([0, 0, 0, 0]);
  });

  it('depth along an orthographic view', async () => {
    const view = { ...camera, type: 'orthographic', height: 4 };
    await show(parseScene({ camera: view, objects: [wall] }), { output: 'depth' });
    const byte = 255 / (1 + 10 / 5);
    for (const [x, y] of [
      [0, 0],
      [12, 9],
    ] as const)
      near(shownAt(x, y), [byte, byte, byte, 255], 1);
  });

  it('depth from afar, through a lens of a third of a degree', async () => {
    const lens = { position: [0, 0, 1000], target: [0, 0, 900], fov: 0.3 };
    const scene = parseScene({ camera: lens, objects: [ball, wall] });
    await show(scene, { output: 'depth' });
    // Rays start near the ball, but depth counts from the camera.
    for (const [x, y, t] of [
      [0, 0, 999],
      [14, 14, 1005],
    ] as const) {
      const byte = 255 / (1 + t / 100);
      near(shownAt(x, y), [byte, byte, byte, 255], 1);
    }
    const { data } = renderReference(scene, { width: 33, height: 33, samples: 4, output: 'depth' });
    const differ = [...renderer.readRadiance()].filter((value, i) => !(Math.abs(value - (data[i] as number)) < 1e-6));
    expect(differ.length).to.be.lessThan(0.01 * data.length);
  });

  for (const output of ['normal', 'depth', 'albedo'] as const) {
    it(`${output} is what the reference says`, async () => {
      const checkered = { type: 'plane', point: [0, -1, 0], color: 'white', checker: 'teal' };
      const lens = { position: [1, 1.5, 5], target: [0, 0, 0], aperture: 0.1 };
      const scene = parseScene({ camera: lens, objects: [ball, checkered, { type: 'torus', axis: [1, 1, 1] }] });
      await show(scene, { output });
      const { data } = renderReference(scene, { width: 33, height: 33, samples: 4, output });
      const found = renderer.readRadiance();
      // Rounding may take a sample over an edge.
      const differ = [...found].filter((value, i) => !(Math.abs(value - (data[i] as number)) < 2e-3));
      expect(differ.length).to.be.lessThan(0.01 * found.length);
    });
  }

  it('goes from one to the next and back to the picture', async () => {
    const scene = parseScene({ camera, objects: [ball, wall] });
    await show(scene, { output: 'albedo' });
    await show(scene, { output: 'normal' });
    near(shownAt(14, 14), [128, 128, 255, 255], 1);
    await show(scene, { output: 'beauty', exposure: 1 });
    expect(shownAt(14, 14)[0]).to.be.greaterThan(2 * (shownAt(14, 14)[1] as number));
  });
});
