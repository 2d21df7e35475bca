import assert from 'node:assert/strict';
import { test } from 'node:test';
import { orbitCamera, panCamera, type ResolvedCamera, zoomCamera } from '@ray-scene/core';

const camera: ResolvedCamera = { position: [1, 2, 8], target: [1, 2, 3], up: [0, 2, 0], fov: 90 };

function assertNear(actual: readonly number[], expected: readonly number[]): void {
  const off = actual.map((x, i) => Math.abs(x - (expected[i] ?? Number.NaN)));
  assert.ok(Math.max(...off) < 1e-12, `[${actual}] is not [${expected}]`);
}

test('an orbit to the right comes to the right side, and one over the top comes above', () => {
  assertNear(orbitCamera(camera, Math.PI / 2, 0).position, [6, 2, 3]);
  assertNear(orbitCamera(camera, 0, Math.PI / 6).position, [1, 2 + 2.5, 3 + 5 * Math.cos(Math.PI / 6)]);
  assertNear(orbitCamera(orbitCamera(camera, 1, 0.5), -1, -0.5).position, camera.position);
});

test('an orbit stops short of the poles, where a camera has no up', () => {
  for (const over of [10, -10]) {
    const { position } = orbitCamera(camera, 0, over);
    assert.ok(Math.abs(position[1] - 2) < 5);
    assert.ok(position[2] > 3);
  }
});

test('a zoom scales the distance, and a pan moves by heights of the picture', () => {
  assertNear(zoomCamera(camera, 0.5).position, [1, 2, 5.5]);
  const panned = panCamera(camera, 0.1, -0.2);
  assertNear(panned.position, [2, 0, 8]);
  assertNear(panned.target, [2, 0, 3]);
});
