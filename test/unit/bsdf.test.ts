// The BSDFs of the f64 reference. The browser tests hold those of the shaders against them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import type { Vec3 } from '@ray-scene/core';
import { type Bsdf, bsdfSample, bsdfValue, isMirrorOnly } from '../../packages/core/src/reference/material/bsdf.ts';
import { exactFresnel } from '../../packages/core/src/reference/material/dielectric.ts';
import { tangents } from '../../packages/core/src/reference/tangents.ts';
import { add, cross, dot, length, negate, normalize, scale, subtract } from '../../packages/core/src/vector.ts';
import { bsdfOf, materials } from '../bsdf/cases.ts';
import { directionTo, type Furnace, histogramError, midpoints, wideMaterials } from '../bsdf/physics.ts';
import { anyMaterial, anyQuestion } from '../bsdf/questions.ts';
import { numbers } from '../bsdf/random.ts';

const SLOPES = [1, 0.7, 0.2, 1e-3, 1e-7, 0];
const ALPHAS = [0, 2 ** -30, 1e-4, 0.01, 0.1, 0.3, 1];

const isClose = (a: number, b: number, limit: number): boolean => Math.abs(a - b) <= limit * Math.abs(b);

test('whatever the material and the directions, answers are numbers', () => {
  const random = numbers(13);
  for (let i = 0; i < 20000; i++) {
    const bsdf = anyMaterial(random);
    const { wo, wi, u, lobe } = anyQuestion(random);
    const [sample, value] = [bsdfSample(bsdf, wo, u, lobe), bsdfValue(bsdf, wo, wi)];
    const answer = [...sample.wi, ...sample.weight, sample.pdf, ...value.value, value.pdf];
    assert.ok(answer.every(Number.isFinite), JSON.stringify([bsdf, wo, wi, u, lobe]));
  }
});

/** Samples for as many random numbers. */
function samples(bsdf: Bsdf, wo: Vec3, count: number, seed = 3) {
  const random = numbers(seed);
  return Array.from({ length: count }, () => bsdfSample(bsdf, wo, [random(), random()], random()));
}

for (const [name, bsdf] of Object.entries(materials)) {
  test(`${name}: a sample has the weight and the density of its direction`, () => {
    for (const wo of SLOPES.map((z) => directionTo(z))) {
      for (const { wi, weight, pdf } of samples(bsdf, wo, 500)) {
        assert.ok([...wi, ...weight, pdf].every(Number.isFinite));
        assert.ok(Math.abs(length(wi) - 1) < 1e-12);
        if (pdf === 0) continue;
        const { value, pdf: again } = bsdfValue(bsdf, wo, wi);
        // The direction alone tells the facet no better than this.
        const limit = 1e-9 + 1e-14 / bsdf.alpha / length(add(wo, wi));
        if (limit > 1e-3) continue;
        assert.ok(isClose(again, pdf, limit), `${again} is not ${pdf}`);
        scale(value, 1 / pdf).forEach((channel, k) => {
          assert.ok(Math.abs(channel - (weight[k] as number)) <= limit * Math.max(...weight));
        });
      }
    }
  });
}

for (const [name, bsdf] of wideMaterials) {
  test(`${name}: directions come as often as their density says, which adds up to 1 with what is lost`, () => {
    for (const wo of [directionTo(0.9), directionTo(0.3)]) {
      const error = histogramError(bsdf, wo, samples(bsdf, wo, 20000));
      assert.ok(error < 4, `off by ${error} standard deviations`);
    }
  });
}

test('a white metal reflects what single scattering between its facets leaves', () => {
  const { alpha, cosTheta, E_sep } = JSON.parse(
    readFileSync(new URL('../truth/data/brdf/furnace.json', import.meta.url), 'utf8'),
  ) as Furnace;
  alpha.forEach((width, i) => {
    const metal = bsdfOf({ metalness: 1, alpha: width });
    cosTheta.forEach((z, k) => {
      const wo = directionTo(z);
      const found = midpoints.reduce((sum, { u, weight }) => sum + weight * bsdfSample(metal, wo, u, 0.5).weight[0], 0);
      // The error of the midpoints, which falls to 1e-6 with 512 by 1024 of them.
      const right = E_sep[i]?.[k] as number;
      assert.ok(Math.abs(found - right) < 2e-4, `alpha ${width}, cosine ${z}: ${found} is not ${right}`);
    });
  });
});

test('no metal and no glass sends out more than it receives, in any direction', () => {
  for (const alpha of ALPHAS) {
    const white = [
      bsdfOf({ alpha, metalness: 1 }),
      ...[{}, { inside: true }, { thin: true }, { ior: 1 }, { specular: 0.5 }, { metalness: 0.5 }].map((looks) =>
        bsdfOf({ alpha, transmission: 1, ...looks }),
      ),
    ];
    for (const bsdf of white) {
      for (const z of SLOPES) {
        for (const { wi, weight } of samples(bsdf, directionTo(z), 200)) {
          // Radiance grows with the square of the index, power does not.
          const scaling = wi[2] < 0 && !bsdf.thin ? bsdf.eta ** 2 : 1;
          assert.ok(weight[0] * scaling <= 1 + 1e-6, `${weight[0]}`);
        }
      }
    }
  }
});

test('what lets a part through and scatters the rest gives back no more than it gets, inside and outside', () => {
  const looks = [{}, { inside: true }, { thin: true }].flatMap((side) => [0.1, 0.5, 0.9].map((t) => ({ ...side, t })));
  for (const alpha of [0, 0.01, 0.25, 1]) {
    for (const { t: transmission, ...side } of looks) {
      const bsdf = bsdfOf({ alpha, transmission, ...side });
      for (const z of [1, 0.8, 0.7, 0.3, 0.01]) {
        const powers = samples(bsdf, directionTo(z), 1000).map(
          ({ wi, weight }) => weight[0] * (wi[2] < 0 && !bsdf.thin ? bsdf.eta ** 2 : 1),
        );
        const mean = powers.reduce((sum, power) => sum + power) / powers.length;
        const variance = powers.reduce((sum, power) => sum + (power - mean) ** 2, 0) / powers.length;
        assert.ok(mean <= 1 + 1e-6 + 4 * Math.sqrt(variance / powers.length), `${JSON.stringify(bsdf)}, ${z}: ${mean}`);
      }
    }
  }
});

test('neither of the lobes of a white dielectric sends out more than it receives', () => {
  const count = 4000;
  const mean = (bsdf: Bsdf, z: number): number =>
    samples(bsdf, directionTo(z), count).reduce((sum, { weight }) => sum + weight[0], 0) / count;
  for (const alpha of ALPHAS) {
    for (const z of SLOPES) {
      const reflected = mean(bsdfOf({ alpha, color: [0, 0, 0] }), z);
      assert.ok(reflected <= 1 + 1e-6);
      const both = mean(bsdfOf({ alpha }), z);
      // The noise of 4000 samples of weights below 2.
      assert.ok(both - reflected <= 1 + 0.05, `alpha ${alpha}, cosine ${z}: ${both} with ${reflected} reflected`);
      if (z === 1) assert.ok(both <= 1 + 0.01);
    }
  }
});

const behind = ([x, y, z]: Vec3): Vec3 => [x, y, -z];

for (const [name, bsdf] of Object.entries(materials)) {
  test(`${name}: light takes the same way back`, () => {
    const random = numbers(5);
    for (let i = 0; i < 400; i++) {
      const wo = directionTo(0.01 + 0.99 * random(), random());
      const wi = directionTo((0.01 + 0.99 * random()) * (i % 2 ? 1 : -1), random());
      const there = scale(bsdfValue(bsdf, wo, wi).value, 1 / Math.abs(wi[2]));
      const back =
        wi[2] > 0
          ? bsdfValue(bsdf, wi, wo)
          : bsdfValue({ ...bsdf, eta: bsdf.thin ? bsdf.eta : 1 / bsdf.eta }, behind(wi), behind(wo));
      const scaling = wi[2] > 0 || bsdf.thin ? 1 : bsdf.eta ** 2;
      back.value.forEach((channel, k) => {
        assert.ok(isClose(channel / wo[2], (there[k] as number) * scaling, 1e-9));
      });
    }
  });
}

test('glass bends light as Snell says, and keeps all of it inside beyond the critical angle', () => {
  for (const alpha of [0, 2 ** -30]) {
    for (const inside of [false, true]) {
      const glass = bsdfOf({ alpha, transmission: 1, inside });
      for (let z = 0.01; z <= 1; z += 0.09) {
        const wo = directionTo(z);
        for (const { wi, weight } of samples(glass, wo, 20)) {
          const isBent = wi[2] < 0;
          const bent = Math.hypot(wo[0], wo[1]) / glass.eta;
          if (bent > 1) assert.ok(!isBent);
          const right = isBent
            ? [-wo[0] / glass.eta, -wo[1] / glass.eta, -Math.sqrt(1 - bent * bent)]
            : [-wo[0], -wo[1], z];
          assert.ok(length(subtract(wi, right as unknown as Vec3)) < 1e-7);
          assert.ok(isClose(weight[0], isBent ? glass.eta ** -2 : 1, 1e-6));
        }
      }
    }
  }
});

test('glass reflects the share that Fresnel says', () => {
  const glass = bsdfOf({ alpha: 0, transmission: 1 });
  for (const z of [1, 0.5, 0.1, 0.01]) {
    const right = exactFresnel(z, glass.eta);
    const isReflected = (lobe: number): boolean => bsdfSample(glass, directionTo(z), [0.3, 0.6], lobe).wi[2] > 0;
    assert.ok(isReflected(right * (1 - 1e-9)) && !isReflected(right * (1 + 1e-9)));
  }
});

test('what is the same on both sides is not there, rough or smooth', () => {
  for (const alpha of ALPHAS) {
    const nothing = bsdfOf({ alpha, ior: 1, transmission: 1, color: [0.9, 0.5, 0.1] });
    for (const z of SLOPES) {
      for (const { wi, weight, pdf } of samples(nothing, directionTo(z), 20)) {
        assert.deepEqual([wi, weight, pdf], [negate(directionTo(z)), nothing.color, 0]);
      }
    }
  }
});

test('a thin pane lets light go straight on', () => {
  const pane = bsdfOf({ alpha: 0, transmission: 1, thin: true });
  for (const z of SLOPES) {
    for (const { wi } of samples(pane, directionTo(z), 50)) {
      assert.ok(length(wi[2] > 0 ? subtract(wi, behind(negate(directionTo(z)))) : add(wi, directionTo(z))) < 1e-12);
    }
  }
});

test('only of mirrors and clear glass is there nothing that lights could be asked for', () => {
  const mirrors = Object.entries(materials).filter(([, bsdf]) => isMirrorOnly(bsdf));
  assert.deepEqual(
    mirrors.map(([name]) => name),
    ['polished gold', 'glass', 'glass from inside', 'pane'],
  );
});

test('tangents and normal are a right-handed frame, to rounding', () => {
  const random = numbers(1);
  for (let i = 0; i < 2000; i++) {
    const n = normalize([random() - 0.5, random() - 0.5, (random() - 0.5) * (i % 2 ? 1 : 1e-9)]);
    const [x, y] = tangents(n);
    for (const product of [dot(x, n), dot(y, n), dot(x, y), length(x) - 1, length(y) - 1]) {
      assert.ok(Math.abs(product) < 2e-15);
    }
    assert.ok(length(subtract(cross(x, y), n)) < 2e-15);
  }
});

test('the frames of floors, walls and roofs do not hang on a rounding', () => {
  const near = (n: Vec3): Vec3 => normalize([n[0] + 1e-7, n[1] - 1e-7, n[2] - 1e-7]);
  const axes: readonly Vec3[] = [1, -1].flatMap((s): Vec3[] => [
    [s, 0, 0],
    [0, s, 0],
    [0, 0, s],
    [s, 1, 0],
    [s, 0, 1],
    [0, s, 1],
    [0, s, -1],
    [0, s * Math.sqrt(3), -1],
    [0, s, -Math.sqrt(3)],
    [s, 1, -1],
  ]);
  for (const n of axes.map(normalize)) {
    const [[x], [again]] = [tangents(n), tangents(near(n))];
    assert.ok(length(subtract(x, again)) < 1e-6);
  }
});
