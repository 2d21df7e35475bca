// Pictures of the f64 reference against another renderer's; `npm run truth -- --only images` renders all, with more samples.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { estimate } from '../truth/images/estimate.ts';
import { readImageTruth } from '../truth/images/image-truth.ts';
import { fewSamples, imageRow } from '../truth/images/judge-image.ts';
import { renderJob } from '../truth/images/reference-job.ts';
import { translateScene } from '../truth/images/translate-scene.ts';

const folder = new URL('../truth/data/images/', import.meta.url);

for (const name of ['furnace_lambert', 'furnace_enclosed', 'analytic_rect_light']) {
  test(`the reference draws ${name} as another renderer does`, async () => {
    const truth = await readImageTruth(
      async (file) => new Uint8Array(await readFile(new URL(`${name}/${file}`, folder))).buffer,
    );
    const translated = translateScene(truth.scene);
    assert.ok(translated.skipped === undefined, translated.skipped);
    const { width, height } = truth;
    const ours = await estimate(
      async (seed, samples) => renderJob({ ...translated, width, height, seed, samples }),
      fewSamples,
    );
    const { disagrees, biasError } = imageRow('reference', ours, truth);
    assert.deepEqual(disagrees, []);
    assert.ok((biasError ?? 1) < 1e-3, `${biasError}`);
  });
}
