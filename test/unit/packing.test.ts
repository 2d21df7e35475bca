import assert from 'node:assert/strict';
import { test } from 'node:test';
import '@ray-scene/core/parts';
import { generateShader, packScene, parseScene, requirements, resolveScene } from '@ray-scene/core';
import fc from 'fast-check';
import { layoutBlock, layoutStruct } from '../../packages/core/src/std140.ts';

test('std140: scalars fill up vectors, vectors start at 16 bytes, arrays have strides of 16', () => {
  const members = [
    { name: 'a', type: 'float' },
    { name: 'b', type: 'vec3' },
    { name: 'c', type: 'float' },
    { name: 'd', type: 'int' },
    { name: 'left out', type: 'vec4', when: 'never' },
    { name: 'e', type: 'vec3', when: 'always !never' },
  ] as const;
  const struct = layoutStruct('S', members, (feature) => feature === 'always');
  assert.deepEqual(
    struct.members.map(({ name, offset }) => [name, offset]),
    [
      ['a', 0],
      ['b', 16],
      ['c', 28],
      ['d', 32],
      ['e', 48],
    ],
  );
  assert.equal(struct.size, 64);
  const block = layoutBlock('B', [
    { name: 'one', struct },
    { name: 'none', struct, count: 0 },
    { name: 'two', struct, count: 2 },
  ]);
  assert.deepEqual(
    block.entries.map(({ name, offset }) => [name, offset]),
    [
      ['one', 0],
      ['two', 64],
    ],
  );
  assert.equal(block.size, 192);
});

const scaled = (v: readonly number[], s: number): number[] => v.map((x) => x * s);

// What is next to nothing is read as 0, at whatever scale.
const length = fc.double({ min: -50, max: 50, noNaN: true }).map((x) => (Math.abs(x) < 1e-9 ? 0 : x));
const triple = fc.tuple(length, length, length).filter((v) => v.some((x) => Math.abs(x) > 1e-3));

test('a scene that is scaled by a power of two, with its intensities, is packed into the same bits', () => {
  fc.assert(
    fc.property(
      triple,
      triple,
      triple,
      fc.double({ min: 0.01, max: 9, noNaN: true }),
      fc.integer({ min: -40, max: 40 }),
      (center, eye, light, radius, k) => {
        const bytes = (s: number) => {
          const scene = resolveScene(
            parseScene({
              camera: { position: scaled(eye, s), target: scaled([100, 3, 2], s) },
              lights: [{ type: 'point', position: scaled(light, s), intensity: 7 * s * s }],
              objects: [
                { type: 'sphere', center: scaled(center, s), radius: radius * s },
                { type: 'plane', point: scaled(center, s), normal: [1, 2, 3], checker: 'red', checkerSize: 0.3 * s },
                {
                  type: 'group',
                  position: scaled(eye, s),
                  rotation: [10, 20, 30],
                  scale: [1, -2, 0.5],
                  objects: [
                    { type: 'box', center: scaled(light, s), size: scaled([1, 2, 3], s) },
                    { type: 'triangle', a: [0, 0, 0], b: [s, 0, 0], c: scaled([0.3, 1, 2], s) },
                  ],
                },
              ],
            }),
          );
          const required = requirements(scene, { bounces: 3 });
          return new Uint8Array(packScene(scene, required, generateShader(required).sceneBlock));
        };
        assert.deepEqual(bytes(2 ** k), bytes(1));
      },
    ),
  );
});

test('nothing that is packed is infinite or not a number, at any scale', () => {
  fc.assert(
    fc.property(triple, triple, fc.integer({ min: -100, max: 100 }), (center, eye, k) => {
      const s = 2 ** k;
      const scene = resolveScene(
        parseScene({
          camera: { position: scaled(eye, s), target: scaled([100, 3, 2], s) },
          lights: [{ type: 'directional', direction: center }],
          objects: [{ type: 'sphere', center: scaled(center, s), radius: s, roughness: 1e-12 }],
        }),
      );
      const required = requirements(scene, { bounces: 3 });
      const floats = new Float32Array(packScene(scene, required, generateShader(required).sceneBlock));
      assert.ok(floats.every(Number.isFinite));
    }),
  );
});
