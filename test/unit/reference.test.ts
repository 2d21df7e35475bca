import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { intersect, type Material, parseScene, type RenderSettings, resolveScene, type Vec3 } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';
import fc from 'fast-check';
import { scattered } from '../../packages/core/src/reference/material/metallic-roughness.ts';
import { add, dot, normalize, scale, subtract } from '../../packages/core/src/vector.ts';

const length = fc.double({ min: -9, max: 9, noNaN: true }).map((x) => Number(x.toFixed(3)));
const triple = fc.tuple(length, length, length);
const direction = triple.filter((v) => Math.hypot(...v) > 0.1);
const share = fc.double({ min: 0, max: 1, noNaN: true });

const ball = (center: Vec3, radius: number) => parseScene({ objects: [{ type: 'sphere', center, radius }] });

test('a hit lies on the sphere, in front of the ray, and its normal points away from the centre', () => {
  fc.assert(
    fc.property(
      triple,
      fc.double({ min: 0.1, max: 5, noNaN: true }),
      triple,
      direction,
      (center, radius, origin, d) => {
        const hit = intersect(ball(center, radius), { origin, direction: d });
        if (!hit) return;
        assert.ok(hit.t > 0);
        assert.ok(Math.abs(Math.hypot(...subtract(hit.position, center)) - radius) < 1e-12 * 30);
        assert.ok(Math.abs(dot(hit.normal, subtract(hit.position, center)) - radius) < 1e-12 * 30);
      },
    ),
  );
});

test('of shapes that are the same in the same place the first counts, in groups too', () => {
  const twins = (shape: object) => [
    { ...shape, color: 'red', name: 'first' },
    { ...shape, color: 'blue' },
    { ...shape, metalness: 1, name: 'third' },
  ];
  const kinds = ['sphere', 'plane', 'disc', 'quad', 'box', 'cylinder', 'cone', 'torus', 'triangle'];
  for (const type of kinds) {
    const { objects, materials } = resolveScene(parseScene({ objects: twins({ type }) }));
    assert.deepEqual(
      objects.map(({ path }) => path),
      [[0]],
      type,
    );
    assert.deepEqual(
      materials.map(({ color }) => color),
      [[1, 0, 0]],
      type,
    );
  }
  const stretched = (scale: number) => ({ type: 'group', scale: [1, scale, 1], objects: [{ type: 'sphere' }] });
  const objects = [
    stretched(2),
    stretched(2),
    stretched(3),
    { type: 'sphere', center: [0, 0, 1e-15] },
    { type: 'sphere' },
  ];
  assert.equal(resolveScene(parseScene({ objects })).objects.length, 4);
});

test('a ray towards a point of the sphere from outside meets the sphere', () => {
  fc.assert(
    fc.property(triple, direction, direction, (center, towards, away) => {
      const radius = 1;
      const onSphere = add(center, normalize(towards));
      const origin = add(center, scale(normalize(away), 3));
      assert.ok(
        intersect(ball(center, radius), { origin, direction: subtract(onSphere, origin) }) ||
          Math.abs(dot(normalize(towards), subtract(onSphere, origin))) < 1e-6,
      );
    }),
  );
});

test('next to a planet the ground is as far away as it is, and so is the horizon', () => {
  const R = 6371000;
  const scene = parseScene({ objects: [{ type: 'sphere', center: [0, -R, 0], radius: R }] });
  const eye: Vec3 = [0, 1.7, 0];
  const down = intersect(scene, { origin: eye, direction: [0, -1, 0] });
  assert.ok(Math.abs((down?.t ?? 0) - 1.7) < 1e-9);
  // A ray a hair below the horizon meets the ground where Pythagoras has it.
  const far = Math.sqrt(1.7 * (2 * R + 1.7));
  const dip = Math.acos(R / (R + 1.7));
  const grazing = intersect(scene, { origin: eye, direction: [Math.cos(dip + 1e-9), -Math.sin(dip + 1e-9), 0] });
  assert.ok(Math.abs((grazing?.t ?? 0) / far - 1) < 0.05);
  assert.equal(
    intersect(scene, { origin: eye, direction: [Math.cos(dip - 1e-9), -Math.sin(dip - 1e-9), 0] }),
    undefined,
  );
});

const material = (given: Partial<Material>): Material =>
  resolveScene(parseScene({ objects: [{ type: 'sphere', ...given }] })).materials[0] as Material;

const upwards = fc.tuple(share, share).map(([u, v]): Vec3 => {
  const z = 0.02 + 0.98 * u;
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(7 * v), r * Math.sin(7 * v), z];
});

const brdf = (m: Material, v: Vec3, l: Vec3): Vec3 =>
  scale(
    scattered({ object: 0, position: [0, 0, 0], normal: [0, 0, 1], front: true, color: m.color, material: m }, v, l),
    1 / l[2],
  );

test('the BRDF is the same both ways', () => {
  fc.assert(
    fc.property(
      upwards,
      upwards,
      share,
      share,
      fc.double({ min: 0.05, max: 1, noNaN: true }),
      (v, l, metalness, specular, roughness) => {
        const m = material({ metalness, specular, roughness });
        brdf(m, v, l).forEach((value, i) => {
          const back = brdf(m, l, v)[i] as number;
          assert.ok(Math.abs(value - back) <= 1e-9 * Math.max(1, value));
        });
      },
    ),
  );
});

test('a white surface reflects no more than it receives, and a dull one all of it', () => {
  // The hemispherical integral by midpoints in cos² and angle.
  const albedo = (m: Material, v: Vec3): number => {
    const steps = 64;
    let sum = 0;
    for (let i = 0; i < steps; i++) {
      for (let j = 0; j < steps; j++) {
        const z = Math.sqrt((i + 0.5) / steps);
        const phi = (2 * Math.PI * (j + 0.5)) / steps;
        const r = Math.sqrt(1 - z * z);
        sum += (Math.PI / steps ** 2) * brdf(m, v, [r * Math.cos(phi), r * Math.sin(phi), z])[0];
      }
    }
    return sum;
  };
  const v = normalize([0.6, 0, 0.8]);
  assert.ok(Math.abs(albedo(material({ specular: 0 }), v) - 1) < 1e-9);
  for (const roughness of [0.4, 0.7, 1]) {
    for (const metalness of [0, 0.5, 1]) {
      const reflected = albedo(material({ roughness, metalness }), v);
      assert.ok(reflected > 0.3 && reflected < 1.01, `roughness ${roughness}, metalness ${metalness}: ${reflected}`);
    }
  }
});

test('a scene scaled by 2^k, with its intensities, gives the same bits', () => {
  const picture = (s: number) =>
    renderReference(
      parseScene({
        camera: { position: [0, 0.5 * s, 4 * s], target: [0, 0.25 * s, 0] },
        lights: [{ type: 'point', position: [3 * s, 4 * s, 5 * s], intensity: 100 * s * s }],
        objects: [
          { type: 'sphere', center: [0, 0.5 * s, 0], radius: s },
          { type: 'plane', point: [0, -s, 0], checker: 'red', checkerSize: 0.75 * s },
        ],
      }),
      { integrator: 'direct', width: 24, height: 16, samples: 2, bounces: 3 },
    ).data;
  for (const k of [-40, -1, 1, 40]) assert.deepEqual(picture(2 ** k), picture(1));
});

test('irradiance falls with the square of the distance, and with the cosine', () => {
  const radiance = (height: number, x: number): number => {
    const scene = parseScene({
      camera: { position: [x, 0.001, 0], target: [x, 0, 0], fov: 1 },
      lights: [{ type: 'point', position: [0, height, 0], intensity: 5 }],
      objects: [{ type: 'plane', specular: 0, color: [0.5, 0.5, 0.5] }],
    });
    return renderReference(scene, { integrator: 'direct', width: 1, height: 1, samples: 1 }).data[0] as number;
  };
  for (const [height, x] of [
    [1, 0],
    [2, 0],
    [3, 4],
  ] as const) {
    const distance = Math.hypot(height, x);
    const expected = ((0.5 / Math.PI) * 5 * (height / distance)) / distance ** 2;
    assert.ok(Math.abs(radiance(height, x) / expected - 1) < 1e-4);
  }
});

test('a lamp on the other side of a plane, or inside a ball, lights nothing here', () => {
  const dark = (light: Vec3) =>
    renderReference(
      parseScene({
        camera: { position: [0, 2, 5], target: [0, 0.5, 0] },
        background: 'black',
        lights: [{ type: 'point', position: light, intensity: 100 }],
        objects: [{ type: 'sphere', center: [0, 0.6, 0], radius: 0.5 }, { type: 'plane' }],
      }),
      { integrator: 'direct', width: 8, height: 8, samples: 1 },
    ).data.filter((_, i) => i % 4 < 3);
  assert.ok(dark([0, -1, 0]).every((value) => value === 0));
  assert.ok(dark([0, 0.7, 0]).every((value) => value === 0));
  assert.ok(dark([0, 3, 3]).some((value) => value > 0));
});

test('along an edge, samples of paths lie here and there; all pixels of `direct` and of outputs have them at one place', () => {
  // Its edge runs down the middle of a column of pixels.
  const half = { type: 'quad', corner: [0.5, -9, 0], edgeU: [9, 0, 0], edgeV: [0, 18, 0], emission: [1, 1, 1] };
  const scene = parseScene({
    camera: { type: 'orthographic', height: 16, position: [0, 0, 5] },
    background: [0, 0, 0],
    objects: [{ ...half, color: [1, 1, 1] }],
  });
  const shownOf = (settings: Partial<RenderSettings>): Set<number> => {
    const { data } = renderReference(scene, { ...settings, width: 16, height: 16, samples: 1, bounces: 1 });
    return new Set(Array.from({ length: 16 }, (_, row) => data[4 * (16 * row + 8)] as number));
  };
  assert.equal(shownOf({ integrator: 'path' }).size, 2);
  assert.equal(shownOf({ integrator: 'direct' }).size, 1);
  assert.equal(shownOf({ integrator: 'path', output: 'albedo' }).size, 1);
});
