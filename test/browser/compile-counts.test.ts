import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import { parseScene, parseSettings, requirements, resolveScene, type Scene } from '@ray-scene/core';
import { RenderDevice, Renderer } from '../../packages/ray-scene/src/renderer.ts';

/** A small generator, so that a failure can be repeated. */
function randomNumbers(seed: number): (min: number, max: number) => number {
  let state = seed;
  return (min, max) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return min + (state / 2 ** 32) * (max - min);
  };
}

/** A scene whose numbers are all random, none of them across the edge of a feature. */
function randomScene(random: (min: number, max: number) => number): Scene {
  const vector = (size: number) => [1, 2, 3].map(() => random(-size, size));
  const color = () => [1, 2, 3].map(() => random(0, 1));
  const surface = () => ({ color: color(), roughness: random(0, 1), ior: random(1, 3) });
  const scale = 10 ** random(-3, 3);
  return parseScene({
    camera: { position: [random(-5, 5), random(5, 9), 100 * scale], target: vector(1), fov: random(10, 120) },
    lights: [
      { type: 'point', position: vector(20), color: color(), intensity: random(0, 100) },
      { type: 'directional', direction: [random(-1, 1), -1, random(-1, 1)], intensity: random(0, 10) },
    ],
    materials: { metal: { metalness: random(0.1, 0.9), ...surface(), specularColor: [0.1, 0.2, random(0, 1)] } },
    objects: [
      { type: 'sphere', center: vector(scale), radius: random(0.1, 2) * scale, ...surface() },
      { type: 'sphere', center: vector(scale), radius: random(0.1, 2) * scale, material: 'metal' },
      {
        type: 'plane',
        point: vector(1),
        normal: [random(-0.1, 0.1), 1, random(-0.1, 0.1)],
        checker: color(),
        checkerSize: random(0.1, 9),
      },
    ],
  });
}

/** One whose lengths do not differ so much that positions take two words, which is an edge between features. */
function narrowScene(random: Parameters<typeof randomScene>[0]): Scene {
  const scene = randomScene(random);
  const { features } = requirements(resolveScene(scene), { bounces: 6 });
  return features.includes('wideRange') ? narrowScene(random) : scene;
}

const withObjects = (...objects: object[]): Scene => parseScene({ objects, lights: [{ type: 'directional' }] });
const sphere = { type: 'sphere' };
const plane = { type: 'plane', point: [0, -1, 0] };

describe('compilation', () => {
  let device: RenderDevice;
  let renderer: Renderer;

  beforeEach(() => {
    device = new RenderDevice();
    renderer = new Renderer(document.createElement('canvas'), device);
    renderer.onerror = (error) => {
      throw error;
    };
    renderer.resize(2, 2);
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 1 }));
  });
  afterEach(() => {
    renderer.dispose();
    device.dispose();
  });

  /** How many programs it takes to draw a scene next. */
  function compilesFor(scene: Scene): number {
    const before = device.compileCount;
    renderer.setScene(scene);
    renderer.draw(1);
    return device.compileCount - before;
  }

  it('happens neither for numbers that change nor for a camera that moves (seed 1)', () => {
    const random = randomNumbers(1);
    compilesFor(narrowScene(random));
    const before = device.compileCount;
    for (let i = 0; i < 1000; i++) {
      renderer.setScene(narrowScene(random));
      if (i % 4 === 0) renderer.draw(1);
    }
    expect(device.compileCount).to.equal(before);
    expect(renderer.stats.compiles).to.equal(1);
    expect(renderer.stats.samples).to.equal(0);
  }).timeout(60_000);

  it('happens once for a first plane, and not for going back', () => {
    compilesFor(withObjects(sphere));
    expect(compilesFor(withObjects(sphere, plane))).to.equal(1);
    expect(compilesFor(withObjects(sphere))).to.equal(0);
    expect(compilesFor(withObjects(sphere, plane))).to.equal(0);
    expect(compilesFor(withObjects(plane))).to.equal(0);
    expect(renderer.stats.compiles).to.equal(2);
  });

  it('happens once for a tone mapping, and not for an exposure', () => {
    compilesFor(withObjects(sphere));
    const before = device.compileCount;
    for (const [toneMapping, exposure] of [
      ['none', 1],
      ['none', 2],
      ['neutral', 3],
    ] as const) {
      renderer.setSettings(parseSettings({ integrator: 'direct', samples: 1, toneMapping, exposure }));
      renderer.draw(1);
    }
    expect(device.compileCount).to.equal(before + 1);
  });

  it('is shared by all views of a device', () => {
    compilesFor(withObjects(sphere));
    const before = device.compileCount;
    const other = new Renderer(document.createElement('canvas'), device);
    other.setSettings(parseSettings({ integrator: 'direct', samples: 1 }));
    other.setScene(withObjects({ ...sphere, color: 'red' }));
    other.draw(1);
    expect(device.compileCount).to.equal(before);
    other.dispose();
  });

  it('is not repeated for a view that is taken away and comes back', () => {
    compilesFor(withObjects(sphere));
    const before = device.compileCount;
    renderer.dispose();
    renderer = new Renderer(document.createElement('canvas'), device);
    renderer.setSettings(parseSettings({ integrator: 'direct', samples: 1 }));
    compilesFor(withObjects(sphere));
    expect(device.compileCount).to.equal(before);
  });
});
