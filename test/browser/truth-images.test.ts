// Pictures of the GPU against another renderer's; `npm run truth -- --only images` renders all, with more samples.
import { expect } from '@open-wc/testing';
import { estimate, inTurns } from '../truth/images/estimate.ts';
import { beginSamples, drawSamples, readRadiance, showPicture } from '../truth/images/gpu-picture.ts';
import { readImageTruth } from '../truth/images/image-truth.ts';
import { fewSamples, imageRow } from '../truth/images/judge-image.ts';
import { withoutAlpha } from '../truth/images/reference-job.ts';
import { translateScene } from '../truth/images/translate-scene.ts';

async function drawn(seed: number, samples: number): Promise<Float64Array> {
  beginSamples({ seed, samples });
  while (!(await drawSamples(1000)));
  return withoutAlpha(readRadiance());
}

describe('pictures of the GPU', function () {
  this.timeout(120_000);

  for (const name of ['furnace_lambert', 'analytic_rect_light']) {
    it(`are as another renderer's: ${name}`, async () => {
      const truth = await readImageTruth(async (file) =>
        (await fetch(`/test/truth/data/images/${name}/${file}`)).arrayBuffer(),
      );
      const translated = translateScene(truth.scene);
      if (translated.skipped !== undefined) throw new Error(translated.skipped);
      const { width, height } = truth;
      showPicture({ scene: JSON.stringify(translated.scene), bounces: translated.bounces, width, height });
      const ours = await estimate(inTurns(drawn), fewSamples);
      const { disagrees, biasError } = imageRow('gpu', ours, truth);
      expect(disagrees).to.deep.equal([]);
      expect(biasError).to.be.below(1e-3);
    });
  }
});
