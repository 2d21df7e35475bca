// Surroundings that are an image: the GPU draws what the reference does, and keeps what it has on the GPU in order.
import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, type Scene } from '@ray-scene/core';
import { illConditioned, relativeDifference, renderReference } from '@ray-scene/core/reference';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';
import { sky } from '../unit/emitter-cases.ts';
import { countObjects, loseAndRestore } from './gl-fixtures.ts';

const SIZE = 48;
const ball = { type: 'sphere', center: [0, 0, 0], radius: 1 };
const floor = { type: 'plane', point: [0, -1, 0], checker: 'black' };
const base = { camera: { position: [0.5, 1, 5] }, environment: { src: 'sky.hdr', rotation: 70, intensity: 1.5 } };
const scenes: { readonly [what: string]: object } = {
  'a dull ball': { ...base, objects: [{ ...ball, specular: 0 }] },
  'a glossy ball and a lamp': {
    ...base,
    lights: [{ type: 'point', position: [2, 3, 4], intensity: 60 }],
    objects: [ball, floor],
  },
  'frosted glass, a mirror and a sun': {
    ...base,
    lights: [{ type: 'directional', direction: [-1, -2, -1], intensity: 2, angularDiameter: 5 }],
    objects: [
      { ...ball, material: 'glass', roughness: 0.3 },
      { ...ball, center: [2, 0, -1], material: 'mirror' },
      floor,
    ],
  },
  'a background of its own': { ...base, background: 'navy', objects: [ball] },
  'nothing else': { ...base, objects: [] },
};

describe('surroundings that are an image', function () {
  this.timeout(120_000);
  const images = new Map([['sky.hdr', sky(32, 16)]]);
  let device: RenderDevice;
  let renderer: Renderer;
  let restored: () => void;

  beforeEach(() => {
    device = new RenderDevice();
    renderer = new Renderer(document.createElement('canvas'), device);
    renderer.onerror = (error) => {
      throw error;
    };
    renderer.onrestored = () => restored();
    renderer.resize(SIZE, SIZE);
  });
  afterEach(() => {
    renderer.dispose();
    device.dispose();
  });

  /** Draws until all samples are there, however often something has to be loaded first. */
  async function complete(): Promise<Float32Array> {
    for (;;) {
      const loaded = new Promise<void>((resolve) => {
        restored = resolve;
      });
      while (renderer.draw(50));
      if (renderer.stopped) return renderer.readRadiance();
      await loaded;
    }
  }

  async function drawn(scene: Scene, integrator: 'path' | 'direct'): Promise<Float32Array> {
    renderer.setSettings(parseSettings({ integrator, samples: 1, bounces: 4 }));
    renderer.setScene(scene, images);
    return complete();
  }

  for (const integrator of ['path', 'direct'] as const) {
    for (const [what, json] of Object.entries(scenes)) {
      it(`${what}, by ${integrator}: the picture is that of the reference`, async () => {
        const scene = parseScene(json);
        const settings = { width: SIZE, height: SIZE, samples: 1, bounces: 4, integrator, images };
        const picture = await drawn(scene, integrator);
        const reference = renderReference(scene, settings);
        const excluded = illConditioned(scene, settings, 1e-3, reference);
        const difference = relativeDifference(picture, reference);
        const judged = difference.filter((_, pixel) => !excluded[pixel]).sort();
        const off = judged.filter((value) => !(value <= 1e-3)).length / judged.length;
        const left = 1 - judged.length / difference.length;
        const median = judged[judged.length >> 1] as number;
        const percent = (share: number): string => `${(100 * share).toFixed(2)} %`;
        console.log(
          `${what}, ${integrator}: median ${median.toExponential(1)}, off ${percent(off)}, left out ${percent(left)}`,
        );
        expect(median, 'median').to.be.below(1e-5);
        expect(off, 'share of pixels off by more than 1e-3').to.be.below(0.005);
        expect(left, 'share of pixels left out').to.be.below(0.03);
      });
    }
  }

  it('without an image that is there, they are dark', async () => {
    renderer.setSettings(parseSettings({ samples: 1 }));
    renderer.setScene(parseScene({ ...base, objects: [ball] }));
    const picture = await complete();
    expect(picture.every((value, i) => value === (i % 4 === 3 ? 1 : 0))).to.equal(true);
  });

  it('the same picture comes back after a loss, and after a scene without them', async () => {
    const scene = parseScene(scenes['a glossy ball and a lamp']);
    const before = await drawn(scene, 'path');
    await loseAndRestore(device.gl);
    expect(await complete()).to.deep.equal(before);
    const plain = await drawn(parseScene({ ...base, environment: { color: 'white' }, objects: [ball] }), 'path');
    expect(Math.max(...plain)).to.be.above(0);
    expect(await drawn(scene, 'path')).to.deep.equal(before);
    expect(device.gl.getError()).to.equal(0);
  });

  it('textures are made once for an image, and freed with the renderer', async () => {
    const counts = countObjects(device.gl);
    await drawn(parseScene({ ...base, objects: [ball] }), 'path');
    const { Texture } = counts;
    await drawn(parseScene({ ...base, environment: { src: 'sky.hdr', rotation: 5 }, objects: [ball] }), 'path');
    expect(counts.Texture).to.equal(Texture);
    renderer.dispose();
    expect(counts.Texture).to.equal(0);
  });
});
