// Scenes that nobody thought of, from 1e-30 to 1e30 times the size of ordinary ones: every pixel is a finite number and that
// of the f64 reference, and no light comes from nowhere.
import { expect } from '@open-wc/testing';
import { parseScene, serializeScene } from '@ray-scene/core';
import fc from 'fast-check';
import { hash } from '../../packages/core/src/random.ts';
import { randomScene } from '../extremes/random-scene.ts';
import { scaleScene } from '../extremes/scale-scene.ts';
import { arbitraryScene } from '../unit/arbitrary-scene.ts';
import { pixelAgreement } from './agreement.ts';
import { drawn } from './drawn.ts';

const { RAY_SCENE_FULL: full = false, RAY_SCENE_SEED: seed = 1 } = globalThis as {
  RAY_SCENE_FULL?: boolean;
  RAY_SCENE_SEED?: number;
};
const runs = full ? 1000 : 40;
const settings = { width: 16, height: 16, samples: 2 };

/** Over all scenes, of the pixels that f64 itself is sure of, so many may differ by more than rounding does. */
const SHARE_OFF = 1e-3;

/** 60 orders of magnitude, from scene to scene. */
const magnitude = (i: number): number => 10 ** ((hash(seed + i) % 61) - 30);

describe('any valid scene', function () {
  this.timeout(900_000);

  it('gives pixels that are finite and not negative', () => {
    fc.assert(
      fc.property(arbitraryScene, fc.integer({ min: -30, max: 30 }), (json, exponent) => {
        // With its defaults, which are to be scaled too.
        const scene = parseScene(scaleScene(serializeScene(parseScene(json)), 10 ** exponent));
        for (const value of drawn(scene, settings)) expect(value).to.be.within(0, 3.4e38);
      }),
      { numRuns: runs, seed, endOnFailure: true, includeErrorInReport: true },
    );
  });

  it('gives pixels that are finite, and those of the f64 reference', () => {
    let [judged, off] = [0, 0];
    for (let i = 0; i < runs; i++) {
      const scene = parseScene(scaleScene(randomScene(seed + i), magnitude(i)));
      const size = { width: 32, height: 32, samples: 1, bounces: 3 };
      const picture = drawn(scene, size);
      for (const value of picture) expect(value, `scene ${seed + i}`).to.be.within(0, 3.4e38);
      const pixels = pixelAgreement(picture, scene, size);
      judged += pixels.judged.length;
      off += pixels.off;
      if (pixels.off > 2) console.log(`fuzz: ${pixels.off} pixels off in scene ${seed + i}`);
    }
    console.log(`fuzz: RAY_SCENE_SEED=${seed}, ${runs} scenes, ${off} of ${judged} pixels off`);
    expect(off / judged).to.be.below(SHARE_OFF);
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
      { numRuns: runs / 2, seed, includeErrorInReport: true },
    );
  });
});
