/** Which samples come next, how many fit into a frame, and when there are enough. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import fc from 'fast-check';
import { AdaptiveOrder } from '../../packages/ray-scene/src/adaptive-order.ts';
import { Cells, type Tile } from '../../packages/ray-scene/src/cells.ts';
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

/** Noise of cells with such spreads of a sample, where they have so many. */
function noiseOf(cells: Cells, spreads: readonly number[]) {
  const errors = Float32Array.from(
    cells.counts,
    (count, i) => (spreads[i % spreads.length] as number) / Math.sqrt(count),
  );
  return { cells: errors, counts: cells.counts.slice() };
}

const squareOfError = (cells: Cells, spreads: readonly number[]): number =>
  cells.counts.reduce((sum, count, i) => sum + (spreads[i % spreads.length] as number) ** 2 / count, 0) /
  cells.counts.length;

const spread = fc.double({ min: 0, max: 1, noNaN: true });

test('samples that go where the error is leave less of it than as many that go everywhere', () => {
  fc.assert(
    fc.property(fc.array(spread, { minLength: 1, maxLength: 60 }), fc.integer({ min: 1, max: 9 }), (spreads, most) => {
      const cells = new Cells(256, 256);
      for (let i = 0; i < 16; i++) cells.add(cells.whole);
      const order = new AdaptiveOrder(noiseOf(cells, spreads));
      while (cells.rays < 64 * 256 * 256) {
        const tiles = order.next(cells, most, 1000);
        if (!tiles) break;
        assert.ok(tiles.reduce((sum, { count }) => sum + count, 0) <= most);
        for (const tile of tiles) cells.add(tile);
      }
      const even = spreads.reduce(
        (sum, s, i) => sum + s ** 2 * [...cells.counts].filter((_, j) => j % spreads.length === i).length,
        0,
      );
      const evenly = even / cells.counts.length / (cells.rays / 256 ** 2);
      // Numbers of samples are multiples of a quarter of them at most, which may leave more where all cells are nearly alike.
      assert.ok(squareOfError(cells, spreads) <= 1.05 * evenly);
    }),
  );
});

test('cells with equally many samples are drawn one after the other, those with fewest first', () => {
  const cells = new Cells(256, 64);
  for (let i = 0; i < 16; i++) cells.add(cells.whole);
  const order = new AdaptiveOrder(noiseOf(cells, [1, 0.5, 0.2, 1, 0.7]));
  const drawn: number[] = [];
  while (cells.rays < 64 * 256 * 64) {
    const tiles = order.next(cells, 2, 1000) as readonly Tile[];
    for (const tile of tiles) {
      drawn.push(cells.countOf(tile));
      cells.add(tile);
    }
  }
  const descents = drawn.filter((count, i) => count < (drawn[i - 1] ?? 0)).length;
  // Goals are set anew with each wave of a twentieth, and only then may any cell fall behind the others.
  assert.ok(descents > 0 && descents <= Math.ceil(Math.log(64 / 16) / Math.log(1.05)), `${descents}`);
});

test('cells of half the spread get half the samples, calm ones a quarter of the mean, none more than it may', () => {
  const cells = new Cells(128, 32);
  for (let i = 0; i < 16; i++) cells.add(cells.whole);
  const order = new AdaptiveOrder(noiseOf(cells, [1, 0.5, 1, 0]));
  const add = (tiles: readonly Tile[]) => {
    for (const tile of tiles) cells.add(tile);
  };
  while (cells.rays < 200 * 128 * 32) add(order.next(cells, 4, 1000) as readonly Tile[]);
  const [first, second, third, calm] = cells.counts as unknown as [number, number, number, number];
  assert.ok(Math.abs(first / third - 1) <= 0.25);
  assert.ok(Math.abs(Math.log2(first / second) - 1) <= Math.log2(1.25));
  assert.ok(calm > 16 && calm < second);
  for (let tiles = order.next(cells, 4, 400); tiles; tiles = order.next(cells, 4, 400)) add(tiles);
  assert.ok(cells.counts.every((count) => count === 400));
});

test('cells that are nearly alike get equally many: smaller tiles would take longer', () => {
  const cells = new Cells(128, 32);
  cells.add(cells.whole);
  assert.equal(new AdaptiveOrder(noiseOf(cells, [1, 0.8, 1.1, 0.9])).next(cells, 4, 100), undefined);
  assert.notEqual(new AdaptiveOrder(noiseOf(cells, [1, 0.3, 1.1, 0.9])).next(cells, 4, 100), undefined);
});

test('without noise nobody is to have more than others', () => {
  const cells = new Cells(64, 64);
  cells.add(cells.whole);
  assert.equal(new AdaptiveOrder(noiseOf(cells, [0])).next(cells, 4, 100), undefined);
});

test('a pace forgets what the first measurement had too much, and follows', () => {
  const pace = new Pace();
  assert.equal(pace.isKnown, false);
  assert.equal(pace.msFor(1000), 0);
  pace.learn(500, 1000);
  pace.learn(1, 1000);
  assert.equal(pace.msFor(1000), 1);
  assert.equal(pace.pixelsIn(12), 12_000);
  for (let i = 0; i < 20; i++) pace.learn(100, 1000);
  assert.ok(pace.msFor(1000) > 99);
});

test('a pace that wavers is taken to be slow rather than fast: frames that are too long are seen', () => {
  const pace = new Pace();
  const measured = [8, 12, 10, 9, 11, 7, 13];
  for (let i = 0; i < 70; i++) pace.learn(measured[i % measured.length] as number, 1);
  assert.ok(pace.msFor(1) > 10 && pace.msFor(1) < 13, `${pace.msFor(1)}`);
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
