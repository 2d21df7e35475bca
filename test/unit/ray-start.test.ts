// Rays of a camera that is far away start ahead of it, before all that can be seen and near it.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { intersect, parseScene, requirements, resolveScene } from '@ray-scene/core';
import fc from 'fast-check';
import { cameraFrame, cameraRay } from '../../packages/core/src/camera-frame.ts';
import { rayStart } from '../../packages/core/src/ray-start.ts';
import { add, length, normalize, scale, type Vec3 } from '../../packages/core/src/vector.ts';

const objects = [
  { type: 'sphere', center: [0.4, 0.7, 0], radius: 0.7 },
  { type: 'plane' },
  { type: 'box', center: [-1, 0.5, 0.3] },
];

const DISTANCE = 1e7;
/** The window shows 4 units of where the objects are. */
const fov = (2 * Math.atan(2 / DISTANCE) * 180) / Math.PI;

const above = fc
  .tuple(...([-1, 0.2, -1] as const).map((min) => fc.double({ min, max: 1, noNaN: true })))
  .map((direction) => normalize(direction as unknown as Vec3));

test('what a far camera sees is behind where its rays start, and not far behind', () => {
  fc.assert(
    fc.property(above, fc.nat(15), fc.nat(15), (direction, x, y) => {
      const camera = { position: scale(direction, DISTANCE), target: [0, 0.5, 0], fov };
      const resolved = resolveScene(parseScene({ camera, objects }));
      const ahead = rayStart(resolved);
      const frame = cameraFrame(resolved.camera, 16, 16);
      const [fromEye, fromPlane] = [0, ahead].map((start) => {
        const ray = cameraRay(frame, x + 0.5, y + 0.5, [0, 0], start);
        return intersect(parseScene({ objects }), { origin: add(frame.origin, ray.start), direction: ray.direction });
      });
      assert.ok(fromEye && fromPlane && fromPlane.object === fromEye.object);
      assert.ok(Math.abs(length(add(fromEye.position, scale(fromPlane.position, -1)))) < 1e-7);
      assert.ok(DISTANCE - ahead < 1e-4 * DISTANCE);
    }),
  );
});

test('with a wider view, or with something at the camera, rays start at the camera', () => {
  const startOf = (camera: object, more: object = { type: 'sphere' }): number =>
    rayStart(
      resolveScene(parseScene({ camera: { position: [0, 2, DISTANCE], ...camera }, objects: [...objects, more] })),
    );
  assert.equal(startOf({}), 0);
  assert.equal(startOf({ fov, aperture: 1 }), 0);
  assert.equal(startOf({ fov }, { type: 'sphere', center: [0, 0, DISTANCE] }), 0);
  assert.ok(startOf({ fov }) > 0);
  assert.ok(startOf({ fov }, { type: 'sphere', center: [0, 0, 2 * DISTANCE] }) > 0, 'what is behind is not seen');
});

test('only where rays start ahead does the shader know of it', () => {
  const has = (camera: object): boolean =>
    requirements(resolveScene(parseScene({ camera, objects })), { bounces: 3 }).features.includes('distant');
  assert.equal(has({ position: [0, 2, DISTANCE], fov }), true);
  assert.equal(has({ position: [0, 2, 6], fov: 40 }), false);
  assert.equal(has({ position: [0, 0.7, 0], target: [1, 0, 0], fov }), false);
});
