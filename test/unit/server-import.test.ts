import assert from 'node:assert/strict';
import { test } from 'node:test';

test('the elements can be imported where there is no DOM', async () => {
  const { RayScene, sceneElements } = await import('ray-scene');
  assert.ok(RayScene.observedAttributes.includes('camera-controls'));
  assert.ok(sceneElements['ray-sphere'].observedAttributes.includes('checker-size'));
});
