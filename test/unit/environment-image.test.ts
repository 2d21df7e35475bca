// Surroundings that are an image: where its texels are, and that directions are drawn by how bright they are.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import type { Vec3 } from '@ray-scene/core';
import { type EnvironmentImage, imageTable, imageTableByRows } from '../../packages/core/src/environment-image.ts';
import { aroundDirection } from '../../packages/core/src/reference/light/emitter/inside.ts';
import { emitterPdf, emitterRadiance, sampleEmitter } from '../../packages/core/src/reference/light/emitters.ts';
import { environmentImage, placeInImage } from '../../packages/core/src/reference/light/environment-image.ts';
import { length } from '../../packages/core/src/vector.ts';
import { average, lightingOf, numbers, sky, surroundedBy } from './emitter-cases.ts';

const ORIGIN: Vec3 = [0, 0, 0];
const AWAY = Number.POSITIVE_INFINITY;

/** A grey image from what is said of its texels. */
const grey = (width: number, height: number, value: (i: number, j: number) => number): EnvironmentImage => ({
  width,
  height,
  data: Float32Array.from({ length: 3 * width * height }, (_, k) =>
    value(Math.floor(k / 3) % width, Math.floor(k / (3 * width))),
  ),
});

/** The direction to the place u, v of an image, from the left and the top. */
const direction = (u: number, v: number): Vec3 => {
  const [psi, theta] = [2 * Math.PI * (u - 0.5), Math.PI * v];
  return [Math.sin(theta) * Math.cos(psi), Math.cos(theta), Math.sin(theta) * Math.sin(psi)];
};

describe('an image of the surroundings', () => {
  it('has its middle at +x, +z a quarter to the right of that, and its top row above', () => {
    const columns = imageTable(grey(8, 4, (i) => i));
    assert.ok(Math.abs(environmentImage(columns, 0, [1, 0, 0])[0] - 3.5) < 1e-12);
    assert.ok(Math.abs(environmentImage(columns, 0, [0, 0, 1])[0] - 5.5) < 1e-12);
    assert.ok(Math.abs(environmentImage(columns, 0, [0, 0, -1])[0] - 1.5) < 1e-12);
    const rows = imageTable(grey(8, 4, (_, j) => j));
    assert.equal(environmentImage(rows, 0, [0, 1, 0])[0], 0);
    assert.equal(environmentImage(rows, 0, [0, -1, 0])[0], 3);
  });

  it('has a texel at its centre, is linear in between, and goes on from the right edge at the left', () => {
    const image = imageTable(grey(8, 4, (i, j) => 10 * j + i * i));
    const at = (u: number, v: number): number => environmentImage(image, 0, direction(u, v))[0];
    assert.ok(Math.abs(at(3.5 / 8, 1.5 / 4) - 19) < 1e-9);
    assert.ok(Math.abs(at(3.75 / 8, 1.5 / 4) - (19 + (26 - 19) / 4)) < 1e-9);
    assert.ok(Math.abs(at(3.5 / 8, 1.75 / 4) - 21.5) < 1e-9);
    assert.ok(Math.abs(at(1 - 1e-12, 1.5 / 4) - (10 + 49 / 2)) < 1e-6);
    assert.ok(Math.abs(at(1e-12, 1.5 / 4) - (10 + 49 / 2)) < 1e-6);
  });

  it('has a table that is made row by row, and once', () => {
    const image = grey(8, 4, (i, j) => i + j);
    const work = imageTableByRows(image);
    let pauses = 0;
    let step = work.next();
    for (; !step.done; step = work.next()) pauses++;
    assert.ok(pauses >= 4);
    assert.equal(imageTable(image), step.value);
    assert.deepEqual(imageTable(grey(8, 4, (i, j) => i + j)), step.value);
  });

  it('turns counterclockwise, seen from above', () => {
    // What was at +x is at -z after a quarter.
    const image = imageTable(grey(8, 4, (i) => i));
    assert.ok(Math.abs(environmentImage(image, 0.25, [0, 0, -1])[0] - 3.5) < 1e-12);
    const { emitters } = lightingOf(
      surroundedBy(
        grey(8, 4, (i) => i),
        2,
        90,
      ),
    );
    assert.ok(Math.abs(emitterRadiance(emitters[0] as (typeof emitters)[number], [0, 0, -1])[0] - 7) < 1e-12);
  });

  it('is drawn from with a density that integrates to 1', () => {
    const lighting = lightingOf(surroundedBy(sky(32, 16), 1, 40));
    const next = numbers(3);
    let [sum, squares] = [0, 0];
    const n = 400_000;
    for (let i = 0; i < n; i++) {
      const pdf = 4 * Math.PI * emitterPdf(lighting, 0, ORIGIN, aroundDirection([next(), next()]), AWAY, 1);
      sum += pdf / n;
      squares += (pdf / n) ** 2;
    }
    assert.ok(Math.abs(sum - 1) < 4 * Math.sqrt(squares) && Math.sqrt(squares) < 0.05, `${sum}`);
  });

  it('is drawn from as that density says, and says of a sample what it says of its direction', () => {
    const image = sky(32, 16);
    const lighting = lightingOf(surroundedBy(image, 3, 40));
    const [emitter] = lighting.emitters;
    const next = numbers(4);
    const { width, height, texels } = imageTable(image);
    const n = 400_000;
    const counts = new Array<number>(width * height).fill(0);
    for (let k = 0; k < n; k++) {
      const d = sampleEmitter(lighting, ORIGIN, next(), [next(), next()])?.direction as Vec3;
      const [x, y] = placeInImage(imageTable(image), 40 / 360, d);
      const texel = Math.floor(y) * width + Math.floor(x);
      counts[texel] = (counts[texel] as number) + 1;
    }
    const expected = counts.map((_, i) => (n * (texels[4 * i + 3] as number)) / (width * height));
    assert.ok(counts.every((count, i) => count === 0 || (expected[i] as number) > 0));
    const judged = expected.flatMap((mean, i) => (mean > 20 ? [((counts[i] as number) - mean) ** 2 / mean] : []));
    const chi2 = judged.reduce((sum, term) => sum + term, 0);
    assert.ok(
      judged.length > 50 && chi2 < judged.length + 5 * Math.sqrt(2 * judged.length),
      `χ² ${chi2} of ${judged.length}`,
    );
    for (let i = 0; i < 2000; i++) {
      const sample = sampleEmitter(lighting, ORIGIN, next(), [next(), next()]);
      assert.ok(sample && emitter && Math.abs(length(sample.direction) - 1) < 1e-12);
      const asked = emitterPdf(lighting, 0, ORIGIN, sample.direction, AWAY, 1);
      assert.ok(Math.abs(asked / sample.pdf - 1) < 1e-9, `${asked}, not ${sample.pdf}`);
      const seen = emitterRadiance(emitter, sample.direction);
      assert.ok(Math.abs(seen[0] - sample.radiance[0]) <= 1e-9 * seen[0]);
    }
  });

  it('gives as much light as there is in it', () => {
    for (const image of [grey(16, 8, () => 1), grey(2, 1, () => 1), grey(1, 1, () => 1)]) {
      const lighting = lightingOf(surroundedBy(image, 2));
      const { mean, error } = average(
        lighting,
        ORIGIN,
        ({ direction: d, radiance, pdf }) => (radiance[0] * Math.max(d[1], 0)) / pdf,
      );
      assert.ok(Math.abs(mean - 2 * Math.PI) < 4 * error + 0.02, `${mean} ± ${error}`);
      assert.ok(Math.abs(imageTable(image).irradiance - 4 * Math.PI) < 1e-6);
    }
    // Nearly all of it from one texel: little noise all the same.
    const lighting = lightingOf(surroundedBy(sky(64, 32)));
    const light = average(lighting, ORIGIN, ({ radiance, pdf }) => radiance[0] / pdf, { n: 20_000 });
    assert.ok(Math.abs(light.mean / imageTable(sky(64, 32)).irradiance - 1) < 0.02 && light.error < 0.01 * light.mean);
  });

  it('leaves no place out that has light, and draws none that has none', () => {
    const image = grey(16, 8, (i, j) => Number(i === 0 && j === 0));
    const { texels } = imageTable(image);
    const densities = [...texels].filter((_, k) => k % 4 === 3);
    // The one texel, those beside it, across the edge too, and those below.
    assert.equal(densities.filter((density) => density > 0).length, 6);
    assert.ok(Math.abs(densities.reduce((sum, density) => sum + density, 0) / 128 - 1) < 1e-6);
    const dark = lightingOf(surroundedBy(grey(4, 2, () => 0)));
    assert.equal(sampleEmitter(dark, ORIGIN, 0.3, [0.4, 0.2]), undefined);
    const wrong = lightingOf(
      surroundedBy(grey(4, 2, (i) => [Number.NaN, -1, Number.POSITIVE_INFINITY, 1][i] as number)),
    );
    const sample = sampleEmitter(wrong, ORIGIN, 0.3, [0.4, 0.2]);
    assert.ok(sample && [...sample.radiance, sample.pdf].every(Number.isFinite));
  });
});
