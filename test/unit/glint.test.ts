// Glints: what paths look for on purpose. The browser tests hold the shader's twin against the same paths.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { loadPaths, parseScene, resolveScene, type Vec3 } from '@ray-scene/core';
import { sceneEmitters } from '../../packages/core/src/emitters.ts';
import { GLINT_FEATURES, type Glint, sceneGlints } from '../../packages/core/src/glints.ts';
import { pixelSampler } from '../../packages/core/src/random.ts';
import { type GlintLobe, glintLobe, glintPdf, glintSample } from '../../packages/core/src/reference/glint.ts';
import { path } from '../../packages/core/src/reference/path.ts';
import { preparePaths } from '../../packages/core/src/reference/path-scene.ts';
import { surfaceFrame, toWorld } from '../../packages/core/src/reference/surface-frame.ts';
import {
  add,
  addScaled,
  cross,
  dot,
  length,
  negate,
  normalize,
  scale,
  subtract,
} from '../../packages/core/src/vector.ts';
import { directionTo } from '../bsdf/physics.ts';
import { numbers } from '../bsdf/random.ts';

const UP = surfaceFrame([0, 1, 0]);

/** A ball and a lamp in front of a surface that looks upwards; lengths over many orders of magnitude. */
function anyPair(random: () => number): { readonly glint: Glint; readonly p: Vec3; readonly lamp: Vec3 } {
  const direction = (): Vec3 => directionTo(2 * random() - 1, random());
  const radius = 10 ** (6 * random() - 3);
  const center = scale(direction(), 10 ** (6 * random() - 3));
  const away = (orders: number): Vec3 => addScaled(center, direction(), radius * (1 + 10 ** (orders * random() - 3)));
  const [p, lamp] = [away(5), away(11)];
  const way = subtract(lamp, center);
  const alpha = 10 ** (3 * random() - 4);
  const shared = { object: 0, center, radius, alpha, strength: 1 };
  return { glint: { ...shared, toLamp: normalize(way), nearness: radius / length(way) }, p, lamp };
}

/** The slope of the half vector against the normal where a ray from p meets the ball; undefined where it does not. */
function slopeAt({ center, radius }: Glint, p: Vec3, d: Vec3, lamp: Vec3): number | undefined {
  const toCenter = subtract(center, p);
  const along = dot(toCenter, d);
  const off2 = length(cross(toCenter, d)) ** 2;
  if (off2 > radius ** 2) return undefined;
  const hit = addScaled(p, d, along - Math.sqrt(radius ** 2 - off2));
  const normal = scale(subtract(hit, center), 1 / radius);
  const half = add(normalize(subtract(lamp, hit)), negate(d));
  return length(cross(half, normal)) / dot(half, normal);
}

const wide: GlintLobe = {
  axis: [0, 0.6, 0.8],
  along: [1, 0, 0],
  across: [0, -0.8, 0.6],
  widths: [0.3, 0.6],
  irradiance: 1,
};

describe('a glint', () => {
  it('is found where the ball mirrors the lamp, and spread as its facets are', () => {
    const random = numbers(1);
    const [errors, spreads]: [number[], number[]] = [[], []];
    for (let i = 0; i < 3000; i++) {
      const { glint, p, lamp } = anyPair(random);
      const lobe = glintLobe(glint, p, UP);
      if (!lobe) continue;
      const slope = slopeAt(glint, p, toWorld(UP, lobe.axis), lamp);
      errors.push(slope ?? 1);
      if (!(slope !== undefined && slope < 1e-6 && lobe.widths[0] > 1e-5 && glint.alpha < 1e-3)) continue;
      for (const [side, width] of [
        [lobe.along, lobe.widths[0]],
        [lobe.across, lobe.widths[1]],
      ] as const) {
        const d = normalize(addScaled(lobe.axis, side, width));
        spreads.push((slopeAt(glint, p, toWorld(UP, d), lamp) ?? 0) / glint.alpha);
      }
    }
    const share = (values: readonly number[], holds: (value: number) => boolean): number =>
      values.filter(holds).length / values.length;
    assert.ok(errors.length > 1000 && spreads.length > 200, `${errors.length}, ${spreads.length}`);
    assert.ok(share(errors, (error) => error < 1e-3) > 0.97, `${share(errors, (error) => error < 1e-3)}`);
    // Not so where the ball is seen at grazing angles.
    const near = share(spreads, (spread) => Math.abs(spread - 1) < 0.02);
    assert.ok(near > 0.9, `${near}`);
  });

  it('is nowhere on what faces away from the surface or the lamp', () => {
    const ball = { object: 0, center: [0, 0, 0], radius: 1, alpha: 0.01, strength: 1, nearness: 0 } as const;
    assert.ok(glintLobe({ ...ball, toLamp: [1, 0, 0] }, [0, 3, 0], UP));
    assert.equal(glintLobe({ ...ball, toLamp: [0, -1, 0] }, [0, 3, 0], UP), undefined);
    assert.equal(glintLobe({ ...ball, toLamp: [1, 0, 0] }, [0, 0.5, 0], UP), undefined);
    assert.equal(glintLobe({ ...ball, toLamp: [1, 0, 0], nearness: 2 }, [0, 3, 0], UP), undefined);
  });

  it('is told in numbers, whatever the lengths, also where the lamp is right behind', () => {
    const random = numbers(2);
    for (let i = 0; i < 5000; i++) {
      const { glint, p } = anyPair(random);
      const toPoint = normalize(subtract(p, glint.center));
      const lobes = [glint, { ...glint, toLamp: toPoint }].map((one) => glintLobe(one, p, UP)).filter((one) => !!one);
      for (const lobe of lobes) {
        const { wi, pdf } = glintSample(lobe, [random(), random()]);
        const answer = [...wi, pdf, glintPdf(lobe, wi), lobe.irradiance, ...lobe.widths];
        assert.ok(answer.every(Number.isFinite) && pdf > 0, JSON.stringify([glint, p]));
        assert.ok(Math.abs(length(wi) - 1) < 1e-9 && lobe.irradiance >= 0);
      }
    }
  });

  it('is the same in a scene of another size', () => {
    const random = numbers(3);
    for (let i = 0; i < 200; i++) {
      const { glint, p } = anyPair(random);
      const large = { ...glint, center: scale(glint.center, 1024), radius: 1024 * glint.radius };
      assert.deepEqual(glintLobe(large, scale(p, 1024), UP), glintLobe(glint, p, UP));
    }
  });

  it('has a density that adds up to 1, as often as which directions are drawn', () => {
    const [bands, turns, fine, count] = [16, 16, 16, 40_000];
    const place = (d: Vec3) => [dot(d, wide.axis), dot(d, wide.along), dot(d, wide.across)] as const;
    const expected = Array.from({ length: bands * turns }, (_, bin) => {
      let sum = 0;
      for (let i = 0; i < fine * fine; i++) {
        const [c, turn] = [
          Math.floor(bin / turns) + (Math.floor(i / fine) + 0.5) / fine,
          (bin % turns) + ((i % fine) + 0.5) / fine,
        ];
        const [x, y, z] = directionTo(c / bands, turn / turns);
        const d = add(add(scale(wide.axis, z), scale(wide.along, x)), scale(wide.across, y));
        sum += glintPdf(wide, d);
      }
      return (count * (sum / fine ** 2) * 2 * Math.PI) / (bands * turns);
    });
    assert.ok(Math.abs(expected.reduce((a, b) => a + b) / count - 1) < 1e-3);
    const random = numbers(4);
    const found = expected.map(() => 0);
    for (let i = 0; i < count; i++) {
      const { wi, pdf } = glintSample(wide, [random(), random()]);
      assert.ok(Math.abs(glintPdf(wide, wi) / pdf - 1) < 1e-9);
      const [c, x, y] = place(wi);
      const turn = (Math.atan2(y, x) / (2 * Math.PI) + 1) % 1;
      const bin = Math.min(Math.floor(c * bands), bands - 1) * turns + Math.floor(turn * turns);
      found[bin] = (found[bin] as number) + 1;
    }
    const judged = expected.map((mean, i) => ({ mean, count: found[i] as number })).filter(({ mean }) => mean > 20);
    const chi2 = judged.reduce((sum, { mean, count: seen }) => sum + (seen - mean) ** 2 / mean, 0);
    assert.ok(judged.length > 100);
    assert.ok(chi2 < judged.length + 5 * Math.sqrt(2 * judged.length), `χ² ${chi2} of ${judged.length}`);
    assert.equal(glintPdf(wide, negate(wide.axis)), 0);
  });
});

const lamp = { type: 'point', position: [3, 5, 2], intensity: 100 };
const ball = { type: 'sphere', center: [0, 1, 0], color: 'gold', metalness: 1, roughness: 0.3 };
const floor = { type: 'plane', roughness: 0.9 };
const camera = { position: [0, 3, 6] };

describe('glints in a scene', () => {
  const glintsOf = (given: object): readonly Glint[] => {
    const scene = resolveScene(parseScene(given), 1);
    return sceneGlints(scene, sceneEmitters(scene));
  };

  it('are of narrow balls and lamps without size alone', () => {
    assert.equal(glintsOf({ lights: [lamp], objects: [ball, floor] }).length, 1);
    assert.equal(glintsOf({ lights: [{ ...lamp, radius: 0.1 }], objects: [ball, floor] }).length, 0);
    for (const roughness of [0, 0.5, 1]) {
      assert.equal(glintsOf({ lights: [lamp], objects: [{ ...ball, roughness }, floor] }).length, 0);
    }
  });

  it('are the strongest where there are many', () => {
    const balls = Array.from({ length: 9 }, (_, i) => ({ ...ball, center: [i * 3, 1, 0], radius: 0.1 * (1 + i) }));
    const glints = glintsOf({ lights: [lamp], objects: balls });
    assert.equal(glints.length, GLINT_FEATURES.length);
    assert.deepEqual(
      glints.map(({ object }) => object),
      [8, 7, 6, 5],
    );
  });

  /** A picture has the same radiance, but for chance, whether glints are looked for or not. */
  const panel = {
    type: 'quad',
    corner: [-3, 3, -1],
    edgeU: [1, 0, 0],
    edgeV: [0, 0, 1],
    emission: [5, 5, 5],
    emissionSide: 'both',
  };
  const scenes: { readonly [what: string]: object } = {
    'a dull floor': { camera, lights: [lamp], objects: [ball, floor] },
    'a glossy floor and a panel': { camera, lights: [lamp], objects: [ball, { ...floor, roughness: 0.4 }, panel] },
    'several balls, a spotlight and a sun': {
      camera,
      lights: [
        { ...lamp, type: 'spot', angle: 40 },
        { type: 'directional', direction: [-1, -2, -1], intensity: 2 },
      ],
      environment: { color: [0.2, 0.2, 0.3] },
      objects: [ball, { ...ball, center: [1.5, 0.5, 1.5], radius: 0.5 }, { ...floor, roughness: 0 }],
    },
    'rough glass in front': {
      camera,
      lights: [lamp],
      objects: [
        ball,
        floor,
        { type: 'sphere', center: [0.8, 0.6, 1.8], radius: 0.6, material: 'glass', roughness: 0.7 },
      ],
    },
  };
  for (const [what, given] of Object.entries(scenes)) {
    it(`change no mean: ${what}`, async () => {
      const resolved = resolveScene(parseScene(given), 1);
      await loadPaths(resolved, { integrator: 'path' });
      const scene = preparePaths(resolved, 'path');
      assert.ok(scene.glints.length > 0);
      const target: Vec3 = [0.9, 0.2, 1.4];
      const ray = {
        origin: resolved.camera.position,
        direction: normalize(subtract(target, resolved.camera.position)),
      };
      const [found, chance] = [scene, { ...scene, glints: [] }].map((one, turn) => {
        const values = Array.from({ length: 60_000 }, (_, i) => {
          const [r, g, b] = path(one, ray, 4, pixelSampler(i % 1000, Math.floor(i / 1000), 0, 5 + turn));
          return r + g + b;
        });
        const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
        const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length ** 2;
        return { mean, variance };
      }) as [{ mean: number; variance: number }, { mean: number; variance: number }];
      const error = Math.sqrt(found.variance + chance.variance);
      assert.ok(found.variance < chance.variance);
      // By chance the lamps in a mirror are met so rarely that more would take minutes.
      const most = what.startsWith('several') ? 0.04 : 0.01;
      assert.ok(error < most * chance.mean, `${chance.mean} ± ${error}`);
      assert.ok(Math.abs(found.mean - chance.mean) < 4 * error, `${found.mean} is not ${chance.mean} ± ${error}`);
    });
  }
});
