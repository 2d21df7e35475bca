// The BSDFs of the f64 reference. The browser tests hold those of the shaders against them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Vec3 } from '@ray-scene/core';
import { bsdfSample, bsdfValue } from '../../packages/core/src/reference/material/bsdf.ts';
import { add, length, scale } from '../../packages/core/src/vector.ts';
import { materials } from '../bsdf/cases.ts';
import { numbers } from '../bsdf/random.ts';

/** A unit vector whose z is given. */
const directionTo = (z: number, turn = 0.1): Vec3 => {
  const r = Math.sqrt((1 - z) * (1 + z));
  return [r * Math.cos(2 * Math.PI * turn), r * Math.sin(2 * Math.PI * turn), z];
};

const SLOPES = [1, 0.7, 0.2, 1e-3, 1e-7, 0];

for (const [name, bsdf] of Object.entries(materials)) {
  test(`${name}: a sample has the weight and the density of its direction`, () => {
    const random = numbers(3);
    for (const z of SLOPES) {
      const wo = directionTo(z);
      for (let i = 0; i < 500; i++) {
        const { wi, weight, pdf } = bsdfSample(bsdf, wo, [random(), random()], random());
        assert.ok([...wi, ...weight, pdf].every(Number.isFinite));
        assert.ok(Math.abs(length(wi) - 1) < 1e-12);
        if (pdf === 0) continue;
        const { value, pdf: again } = bsdfValue(bsdf, wo, wi);
        // The direction alone tells the facet no better than this.
        const limit = 1e-9 + 1e-14 / bsdf.alpha / length(add(wo, wi));
        if (limit > 1e-3) continue;
        assert.ok(Math.abs(again / pdf - 1) < limit, `${again} is not ${pdf}`);
        scale(value, 1 / pdf).forEach((channel, k) => {
          assert.ok(Math.abs(channel - (weight[k] as number)) <= limit * Math.max(...weight));
        });
      }
    }
  });
}
