/** Which samples come next, how many fit into a frame, and when there are enough. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import fc from 'fast-check';
import { Cells } from '../../packages/ray-scene/src/cells.ts';
import { Pace } from '../../packages/ray-scene/src/pace.ts';
import { FEWEST_SAMPLES, stopReason } from '../../packages/ray-scene/src/stop-rules.ts';

const size = fc.integer({ min: 1, max: 700 });

test('tiles of any size cover every pixel once before they cover one twice', () => {
  fc.assert(
    fc.property(size, size, fc.array(fc.integer({ min: 1, max: 500 }), { minLength: 1 }), (width, height, sizes) => {
      const cells = new Cells(width, height);
      let pixels = 0;
      for (let i = 0; cells.least < 2; i++) {
        const most = sizes[i % sizes.length] as number;
        const tile = cells.next(most);
        assert.ok(tile.count <= most);
        assert.equal(cells.countOf(tile), cells.least);
        cells.add(tile);
        pixels += cells.pixelsOf(tile);
        assert.ok(cells.counts.every((count) => count === cells.least || count === cells.least + 1));
      }
      assert.equal(pixels, 2 * width * height);
      assert.equal(cells.rays, pixels);
    }),
  );
});

test('a tile that may be as large as the picture is the picture', () => {
  const cells = new Cells(600, 400);
  assert.deepEqual(cells.next(1e9), cells.whole);
  assert.equal(cells.pixelsOf(cells.whole), 600 * 400);
});

test('a pace forgets what the first measurement had too much, and follows', () => {
  const pace = new Pace();
  assert.equal(pace.isKnown, false);
  assert.equal(pace.msFor(1000), 0);
  pace.learn(500, 1000);
  pace.learn(1, 1000);
  assert.equal(pace.msFor(1000), 1);
  assert.equal(pace.pixelsIn(12), 12_000);
  for (let i = 0; i < 10; i++) pace.learn(100, 1000);
  assert.ok(pace.msFor(1000) > 99);
});

const noise = (error: number, samples = 64) => ({ error, samples });

test('whichever rule comes first ends a picture', () => {
  const settings = { samples: 100, maxError: 0.02, maxTime: 3 };
  const at = (standing: Partial<Parameters<typeof stopReason>[1]>) =>
    stopReason(settings, { samples: 64, seconds: 1, noise: undefined, ...standing });
  assert.equal(at({}), undefined);
  assert.equal(at({ noise: noise(0.021) }), undefined);
  assert.equal(at({ noise: noise(0.02) }), 'error');
  assert.equal(at({ samples: 100 }), 'samples');
  assert.equal(at({ seconds: 3 }), 'time');
});

test('nothing ends a picture that has no sample, and no luck one of a few', () => {
  const settings = { samples: 1, maxError: 1, maxTime: 1 };
  assert.equal(stopReason(settings, { samples: 0, seconds: 9, noise: noise(0) }), undefined);
  const few = { samples: 5, seconds: 0, noise: noise(0, FEWEST_SAMPLES - 1) };
  assert.equal(stopReason({ ...settings, samples: 100 }, few), undefined);
});
