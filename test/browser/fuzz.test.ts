// Scenes that nobody thought of: every pixel is a finite number, and no light comes from nowhere.
import { expect } from '@open-wc/testing';
import { parseScene } from '@ray-scene/core';
import fc from 'fast-check';
import { arbitraryScene } from '../unit/arbitrary-scene.ts';
import { drawn } from './drawn.ts';

const runs = (globalThis as { RAY_SCENE_FULL?: boolean }).RAY_SCENE_FULL ? 1000 : 40;
const settings = { width: 16, height: 16, samples: 2 };

describe('any valid scene', function () {
  this.timeout(300_000);

  it('gives pixels that are finite and not negative', () => {
    fc.assert(
      fc.property(arbitraryScene, (json) => {
        for (const value of drawn(parseScene(json), settings)) expect(value).to.be.within(0, 3.4e38);
      }),
      { numRuns: runs, endOnFailure: true },
    );
  });

  it('reflects no more light than falls on it', () => {
    const share = fc.double({ min: 0, max: 1, noNaN: true });
    const surface = fc.record({
      metalness: share,
      roughness: share,
      specular: share,
      ior: fc.double({ min: 1, max: 9, noNaN: true }),
    });
    fc.assert(
      fc.property(surface, surface, (a, b) => {
        const scene = parseScene({
          camera: { position: [0, 1, 5] },
          environment: { color: 'white' },
          objects: [
            { type: 'sphere', ...a },
            { type: 'plane', point: [0, -1, 0], ...b },
          ],
        });
        for (const value of drawn(scene, settings)) expect(value).to.be.at.most(1.00001);
      }),
      { numRuns: runs / 2 },
    );
  });
});
