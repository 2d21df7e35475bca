// Which light is asked, what lights without a surface give, and what is answered where nothing is well defined.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import type { Vec3 } from '@ray-scene/core';
import { aliasTable, choose, emitterTable } from '../../packages/core/src/emitter-table.ts';
import { sceneEmitters } from '../../packages/core/src/emitters.ts';
import { emitterPdf, sampleEmitter } from '../../packages/core/src/reference/light/emitters.ts';
import { addScaled, dot, normalize, subtract } from '../../packages/core/src/vector.ts';
import { average, emittingScene, inside, lightingOf, lights, numbers, outside, shapes } from './emitter-cases.ts';

type Name = keyof typeof shapes;
const names = Object.keys(shapes) as Name[];

describe('lights', () => {
  it('of a point fade with the distance squared, or not', () => {
    const far: Vec3 = [0.5, 2, 99];
    const [fading, steady] = [lights.point, lights['steady point']].map((light) =>
      sampleEmitter(lightingOf(emittingScene([light], [])), far, 0, [0, 0]),
    );
    assert.equal(fading?.radiance[0], 1e-4);
    assert.equal(steady?.radiance[0], 1);
    assert.deepEqual(fading?.direction, [0, 0, -1]);
    assert.ok(fading?.delta && fading.distance === 100);
  });

  it('of a spot fall linearly in the angle', () => {
    const light = { ...lights.spot, position: [0, 0, 0], direction: [0, 0, 1], target: undefined } as const;
    const { target: _, ...spot } = light;
    const lighting = lightingOf(emittingScene([spot], []));
    for (const [degrees, share] of [
      [0, 1],
      [19.9, 1],
      [25, 0.75],
      [30, 0.5],
      [39, 0.05],
      [41, 0],
      [180, 0],
    ] as const) {
      const angle = (degrees * Math.PI) / 180;
      const sample = sampleEmitter(lighting, [Math.sin(angle), 0, Math.cos(angle)], 0, [0, 0]);
      assert.ok(Math.abs((sample?.radiance[0] as number) - share) < 1e-12, `${degrees}: ${sample?.radiance}`);
    }
  });

  it('of a sun give a surface that faces it what they say', () => {
    for (const light of [lights['the Sun'], lights['a wide sun']]) {
      const lighting = lightingOf(emittingScene([light], []));
      const toLight = normalize(subtract([0, 0, 0], light.direction));
      const { mean, error } = average(lighting, [0, 0, 0], ({ direction, radiance, pdf }) => {
        assert.equal(emitterPdf(lighting, 0, [0, 0, 0], direction, Number.POSITIVE_INFINITY, 1), pdf);
        return (radiance[0] * dot(direction, toLight)) / pdf;
      });
      assert.ok(Math.abs(mean - 2) < 4 * error + 1e-9, `${mean} ± ${error}`);
      assert.equal(emitterPdf(lighting, 0, [0, 0, 0], light.direction, Number.POSITIVE_INFINITY, 1), 0);
    }
  });

  it('of a ball aim as their spotlight does', () => {
    const light = { ...lights.spot, radius: 0.1 };
    const scene = emittingScene([light], [{ type: 'sphere', center: light.position, radius: 0.1 }]);
    const lighting = lightingOf({ ...scene, objects: scene.objects.map((object) => ({ ...object, light: 0 })) });
    assert.equal(lighting.emitters.length, 1);
    const seen = (p: Vec3) => average(lighting, p, ({ radiance }) => radiance[0]).mean;
    assert.ok(seen([0, 0, 0.3]) === 1 && seen([0, 5, 0]) === 0);
  });
});

describe('choosing an emitter', () => {
  it('does so as often as its probability says', () => {
    const next = numbers(11);
    for (const weights of [[1], [1, 2], [0, 3, 0, 5, 1e-3], [1e300, 1, 0], Array.from({ length: 37 }, () => next())]) {
      const { probabilities, thresholds, aliases } = aliasTable(Float64Array.from(weights));
      const total = weights.reduce((sum, weight) => sum + weight / Math.max(...weights), 0);
      // Exactly: the share of the thresholds and of what is left above them.
      const exact = weights.map(
        (_, i) =>
          thresholds.reduce((sum, q, j) => sum + (j === i ? q : 0) + (aliases[j] === i ? 1 - q : 0), 0) /
          weights.length,
      );
      weights.forEach((weight, i) => {
        assert.equal(probabilities[i], Math.fround(exact[i] as number));
        assert.ok(Math.abs((probabilities[i] as number) - weight / Math.max(...weights) / total) < 1e-6);
        if (weight === 0) assert.equal(probabilities[i], 0);
      });
      const counts = weights.map(() => 0);
      const n = 2 ** 16;
      for (let i = 0; i < n; i++) {
        const chosen = choose({ probabilities, thresholds, aliases }, i / n);
        counts[chosen] = (counts[chosen] as number) + 1;
      }
      assert.ok(counts.every((count, i) => Math.abs(count / n - (probabilities[i] as number)) < 1e-3));
      assert.ok(weights[choose({ probabilities, thresholds, aliases }, 1 - 2 ** -24)] !== 0);
    }
  });

  it('leaves out what has no light, and all of them if none has', () => {
    const dark = { ...lights.point, intensity: 0 };
    const lighting = lightingOf(emittingScene([dark, lights.point, dark], []));
    assert.deepEqual([...lighting.table.probabilities], [0, 1, 0]);
    for (const scene of [emittingScene([dark, dark], []), emittingScene([dark], []), emittingScene([], [])]) {
      assert.equal(sampleEmitter(lightingOf(scene), [0, 0, 0], 0.3, [0.5, 0.5]), undefined);
    }
    assert.deepEqual([...emitterTable([]).probabilities], []);
  });

  it('prefers what lights the scene more, and forgets no light', () => {
    const { emitters, table } = lightingOf(
      emittingScene([lights.point, { ...lights.point, position: [0, 1000, 0] }, lights.directional], [shapes.sphere]),
    );
    const [near, far, sun, ball] = [...table.probabilities] as [number, number, number, number];
    assert.ok(near > far && far > 0 && sun > 0 && ball > 0);
    assert.deepEqual(
      emitters.map(({ kind }) => kind),
      ['point', 'point', 'directional', 'sphere'],
    );
    assert.deepEqual(sceneEmitters(emittingScene([], [{ type: 'plane', point: [0, 0, 0], normal: [0, 1, 0] }])), []);
  });
});

describe('asking where nothing is well defined', () => {
  it('gives no light or a finite one', () => {
    const corners = [0, 1, 0.5, 1 - 2 ** -24];
    for (const name of names) {
      for (const side of ['front', 'back', 'both'] as const) {
        const lighting = lightingOf(emittingScene([], [shapes[name]], side));
        const samples = corners.flatMap((u) =>
          corners.map((v) => sampleEmitter(lighting, outside[0] as Vec3, 0, [u, v])),
        );
        const on = samples.flatMap((one) => (one ? [addScaled(outside[0] as Vec3, one.direction, one.distance)] : []));
        for (const p of [...on, ...(inside[name] ? [inside[name] as Vec3] : []), middle(name)]) {
          for (const own of [undefined, 0]) {
            for (const u of corners) {
              const sample = sampleEmitter(lighting, p, 0.5, [u, 0.25], own);
              if (!sample) continue;
              const all = [...sample.direction, sample.distance, ...sample.radiance, sample.pdf];
              assert.ok(all.every(Number.isFinite), `${name} from ${p}: ${all}`);
            }
          }
        }
      }
    }
    for (const light of Object.values(lights)) {
      const lighting = lightingOf(emittingScene([light], []));
      for (const p of [
        [0.5, 2, -1],
        [0.5, -7, -1],
        [1e300, 0, 0],
      ] as const) {
        const sample = sampleEmitter(lighting, p, 0.5, [0.5, 0.5]);
        assert.ok(!sample || [...sample.direction, ...sample.radiance, sample.pdf].every(Number.isFinite));
      }
    }
  });
});

function middle(name: Name): Vec3 {
  const shape = shapes[name] as { readonly [field: string]: unknown };
  return (shape.center ?? shape.corner ?? shape.a ?? shape.base) as Vec3;
}
