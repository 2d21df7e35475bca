import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  type Feature,
  mergeRequirements,
  parseScene,
  requirements,
  requirementsKey,
  resolveScene,
} from '@ray-scene/core';
import fc from 'fast-check';

type Json = { readonly [key: string]: unknown };

const required = (scene: object) => requirements(resolveScene(parseScene(scene)), { bounces: 6 });
const key = (scene: object) => requirementsKey(required(scene));

const sphere: Json = { type: 'sphere', center: [0, 0, 0], radius: 1, color: [0.5, 0.2, 0.1] };
const floor: Json = { type: 'plane', point: [0, -1, 0], checker: [0, 0, 0] };
const lamp: Json = { type: 'point', position: [0, 5, 0], intensity: 10 };
const scene = { camera: { position: [0, 1, 5] }, lights: [lamp], objects: [sphere, floor] };

const length = fc.double({ min: -20, max: 20, noNaN: true });
const triple = fc.tuple(length, length, length);
const share = fc.double({ min: 0, max: 1, noNaN: true });
const color = fc.tuple(share, share, share);

test('moving, recolouring and resizing anything requires the same shader', () => {
  const before = key(scene);
  fc.assert(
    fc.property(triple, triple, color, share, triple, color, (center, point, paint, size, position, light) => {
      const objects = [
        { ...sphere, center, radius: 2 + size, color: paint, ior: 1 + size },
        { ...floor, point, color: paint, checker: light, checkerSize: 0.1 + size },
      ].map((object) => ({ ...object, roughness: size }));
      const lights = [{ ...lamp, position, color: light, intensity: 100 * size }];
      const camera = { position: [1, 30 + size, 5], fov: 10 + 100 * size };
      assert.equal(key({ camera, lights, objects }), before);
    }),
  );
});

const switches: readonly [what: string, change: (scene: typeof base) => object, features: readonly Feature[]][] = [
  ['a metal', (s) => ({ ...s, objects: [{ ...sphere, metalness: 1 }, floor] }), ['metal']],
  ['a checker on a sphere', (s) => ({ ...s, objects: [{ ...sphere, checker: 'red' }, floor] }), ['sphereChecker']],
  ['a tint of reflections', (s) => ({ ...s, objects: [{ ...sphere, specularColor: 'red' }, floor] }), ['specularTint']],
  ['a weaker reflection', (s) => ({ ...s, objects: [{ ...sphere, specular: 0.5 }, floor] }), ['specularWeight']],
  [
    'a plane that is not level',
    (s) => ({ ...s, objects: [sphere, { ...floor, normal: [1, 1, 0] }] }),
    ['tiltedPlane', 'turnedChecker'],
  ],
  ['light that does not fade', (s) => ({ ...s, lights: [lamp, { ...lamp, decay: 0 }] }), ['noFalloff', 'mixedFalloff']],
  ['an environment', (s) => ({ ...s, environment: { color: 'white' } }), ['environment', 'backgroundEnvironment']],
  [
    'a gradient',
    (s) => ({ ...s, environment: { top: 'white', bottom: 'red' } }),
    ['environment', 'gradient', 'backgroundEnvironment'],
  ],
  ['a background', (s) => ({ ...s, background: 'red' }), ['backgroundColor']],
  [
    'a camera inside a ball',
    (s) => ({ ...s, camera: { position: [0, 0, 0.5], target: [0, 0, -1] } }),
    ['closeSphere', 'inside'],
  ],
  [
    'a camera next to a ball',
    (s) => ({ ...s, camera: { position: [0, 0, 1.4], target: [0, 0, -1] } }),
    ['closeSphere'],
  ],
];
const base = scene;

for (const [what, change, added] of switches) {
  test(`${what} adds ${added.join(', ')} and nothing else`, () => {
    const before = required(base).features;
    const after = required(change(base)).features;
    assert.deepEqual(after.filter((feature) => !before.includes(feature)).sort(), [...added].sort());
  });
}

test('one convex shape that is lit from outside needs no shadows', () => {
  const alone = { camera: scene.camera, lights: [lamp], objects: [sphere] };
  assert.ok(!required(alone).features.includes('shadows'));
  assert.ok(required(scene).features.includes('shadows'));
});

test('without reflection there are neither highlights nor bounces', () => {
  const dull = {
    ...scene,
    objects: [
      { ...sphere, specular: 0 },
      { ...floor, specular: 0 },
    ],
  };
  for (const feature of ['specular', 'reflective', 'highlights', 'reflections'] as const) {
    assert.ok(!required(dull).features.includes(feature), feature);
  }
});

test('features and places that were needed once stay', () => {
  const rich = required({
    ...scene,
    objects: [{ ...sphere, metalness: 1 }, { ...sphere, radius: 2 }, floor, { ...floor, point: [0, -2, 0] }],
  });
  const both = mergeRequirements(rich, required(scene));
  assert.equal(requirementsKey(both), requirementsKey(mergeRequirements(both, required(scene))));
  assert.deepEqual([both.shapes.sphere, both.shapes.plane], [2, 2]);
  assert.ok(both.features.includes('metal'));
});

test('many objects grow in steps', () => {
  const many = (count: number) => key({ ...scene, objects: Array.from({ length: count }, () => sphere) });
  assert.equal(new Set([9, 10, 12, 15, 16].map(many)).size, 1);
});
