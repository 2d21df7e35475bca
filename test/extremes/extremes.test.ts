// The stress set against the f64 reference, path by path; and the same bits at any scale.
import { expect } from '@open-wc/testing';
import { parseScene } from '@ray-scene/core';
import { expectAgreement, SIDE } from '../browser/agreement.ts';
import { drawn } from '../browser/drawn.ts';
import { scaleScene } from './scale-scene.ts';
import { extremes } from './scenes.ts';

describe('at the extremes', function () {
  this.timeout(120_000);

  for (const [what, scene] of Object.entries(extremes)) {
    it(`draws ${what} as f64 does`, () =>
      expectAgreement(what, parseScene(scene), { width: SIDE, height: SIDE, bounces: 4, samples: 1 }));

    it(`draws ${what} with the same bits at any scale`, () => {
      const bits = (factor: number): Uint32Array =>
        new Uint32Array(
          drawn(parseScene(scaleScene(scene, factor)), { width: 48, height: 48, bounces: 4, samples: 1 }).buffer,
        );
      const unscaled = bits(1);
      for (const power of [-40, 40]) expect(bits(2 ** power), `times 2^${power}`).to.deep.equal(unscaled);
    });
  }
});
