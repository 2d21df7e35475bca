import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { hash } from '../../packages/core/src/random.ts';
import { noisyPixels, relativeNoise, tailIndex } from '../bench/calibration/tail.ts';
import { readOptions, USAGE } from '../bench/options.ts';
import { beating, type Choice, frontOf, sceneChoices } from '../bench/trade/front.ts';
import { BASE } from '../bench/trade/knobs.ts';
import type { Measured } from '../bench/trade/measure.ts';
import { plotTrade } from '../bench/trade/plots.ts';
import { bounceFromBase, galleryBounces, sceneSection } from '../bench/trade/scene-section.ts';
import { average, biasOf, noiseOf, psnr, Spread, yardstickOf } from '../bench/trade/statistics.ts';
import { normalRandom } from './normal-random.ts';

const NUMBERS = 3 * 2000;

/** Pictures of one grey, off by a constant, each number with noise of its own. */
function pictures(
  count: number,
  { mean, deviation, numbers = NUMBERS }: { mean: number; deviation: number; numbers?: number },
  seed: number,
  noise = normalRandom,
): Spread {
  const random = noise(seed);
  const spread = new Spread(numbers);
  for (let i = 0; i < count; i++) {
    spread.add(Float32Array.from({ length: numbers }, () => mean + deviation * random()));
  }
  return spread;
}

/** A rare bright event: Pareto's distribution of index 3, whose variance is finite and whose third moment is not; mean 0. */
function heavyTails(seed: number): () => number {
  let state = hash(seed);
  const mean = 3 / 2;
  return () => {
    state = hash(state + 1);
    return ((state + 0.5) / 2 ** 32) ** (-1 / 3) - mean;
  };
}

describe('the statistics of the trade', () => {
  const grey = { mean: 1, deviation: 0.02 };
  const yardstick = yardstickOf(pictures(4, grey, 1));
  const right = pictures(4, grey, 11);

  it('tell noise apart from bias', () => {
    const spread = pictures(6, { mean: 1.05, deviation: 0.2 }, 2);
    const { noise } = noiseOf(spread, yardstick);
    const { bias, biasAtMost } = biasOf(spread, yardstick, right);
    assert.ok(Math.abs(noise / (0.2 / Math.sqrt(1.01)) - 1) < 0.03, `${noise}`);
    assert.ok(Math.abs(bias / (0.05 / Math.sqrt(1.01)) - 1) < 0.1, `${bias}`);
    assert.ok(biasAtMost > bias);
  });

  it('find no more bias than chance allows where there is none', () => {
    const { bias, biasAtMost } = biasOf(pictures(6, { mean: 1, deviation: 0.2 }, 3), yardstick, right);
    assert.ok(bias < biasAtMost && biasAtMost < 0.04, `${bias} ${biasAtMost}`);
  });

  /** Squared bias of two pictures with heavy tails, again and again, over its standard error in the mean of all. */
  function meanSquaredBias(trials: number, bias: number): { readonly mean: number; readonly error: number } {
    const [numbers, deviation] = [600, 0.3];
    const found = Array.from({ length: trials }, (_, i) => {
      const of = (count: number, mean: number, seed: number) =>
        pictures(count, { mean, deviation, numbers }, 4 * i + seed, heavyTails);
      return biasOf(of(2, 1 + bias, 1000), yardstickOf(of(3, 1, 1001)), of(3, 1, 1002)).squaredBias;
    });
    const mean = average(found);
    return { mean, error: Math.sqrt(average(found.map((value) => (value - mean) ** 2)) / trials) };
  }

  it('find none in the mean where there is none, although two pictures with heavy tails tell little', () => {
    const { mean, error } = meanSquaredBias(400, 0);
    assert.ok(error < 0.0003 && Math.abs(mean) < 3 * error, `${mean} ± ${error}`);
  });

  it('find in the mean what there is', () => {
    const { mean, error } = meanSquaredBias(400, 0.2);
    // Divided by the squares of means that have noise themselves, which is a little more.
    assert.ok(mean > 0.2 ** 2 / 1.01 - 3 * error && mean < 1.1 * 0.2 ** 2 + 3 * error, `${mean} ± ${error}`);
  });

  it('know what paths leave out, far below the noise, from pictures with the same random numbers', () => {
    const noise = normalRandom(5);
    const left = new Spread(NUMBERS);
    for (let i = 0; i < 2; i++) left.add(Float32Array.from({ length: NUMBERS }, () => -0.001 * (1 + 0.3 * noise())));
    const { bias, biasAtMost } = biasOf(left, yardstick);
    assert.ok(
      Math.abs(bias / (0.001 / Math.sqrt(1.01)) - 1) < 0.02 && biasAtMost < 1.1 * bias,
      `${bias} ${biasAtMost}`,
    );
  });

  it('leave out the same pixels of all pictures, those where converged ones of either kind differ most', () => {
    const bright = (first: number): Spread => {
      const random = normalRandom(4 + first);
      const spread = new Spread(NUMBERS);
      for (let i = 0; i < 6; i++) {
        const deviation = (j: number): number => (j >= first && j < first + 30 ? 1000 : 0.1);
        spread.add(Float32Array.from({ length: NUMBERS }, (_, j) => 1 + deviation(j) * random()));
      }
      return spread;
    };
    const one = noiseOf(bright(0), yardstickOf(pictures(4, grey, 1), bright(0)));
    assert.ok(one.rareShare > 0.99 && one.noiseOfAll > 10 && Math.abs(one.noise - 0.1) < 0.01, `${one.noise}`);
    const other = noiseOf(bright(60), yardstickOf(pictures(4, grey, 1), bright(0)));
    assert.ok(other.rareShare < 0.01 && other.noise > 10, `${other.noise}`);
  });

  it('know the signal over the noise of pictures that are a tenth apart', () => {
    assert.ok(Math.abs(psnr([0.5, 0.5], [0.6, 0.4]) - 20) < 1e-9);
  });
});

const choice = (milliseconds: number, error: number): Choice => ({
  name: `${milliseconds}`,
  setting: BASE,
  samples: 1,
  milliseconds,
  error,
  measured: true,
});

const measured = (known: Partial<Measured>): Measured => ({
  name: '',
  knob: 'none',
  setting: BASE,
  shaderChars: 1,
  compileMs: 1,
  firstFrameMs: 1,
  timeRatios: [1],
  msPerSample: 1,
  msSpread: 0,
  msPerFrame: 1,
  msPerFrameSpread: 0,
  seeds: 2,
  points: [{ samples: 16, noise: 0, noiseOfAll: 0, rareShare: 0, psnr: 1, flip: 0 }],
  squaredBias: (known.bias ?? 0) ** 2,
  bias: 0,
  biasAtMost: 0,
  ...known,
});

describe('the tail of errors', () => {
  /** Pictures of a grey, each number off by what `errorOf` makes of a random one between 0 and 1. */
  function pictures(errorOf: (u: number) => number): { readonly all: Float32Array[]; readonly spread: Spread } {
    const all = Array.from({ length: 8 }, (_, k) =>
      Float32Array.from({ length: NUMBERS }, (_, i) => 1 + errorOf((hash(k * NUMBERS + i) + 0.5) / 2 ** 32)),
    );
    const spread = new Spread(NUMBERS);
    for (const one of all) spread.add(one);
    return { all, spread };
  }

  it('is that of the law by which large ones become rare', () => {
    for (const index of [1, 3]) {
      const { all, spread } = pictures((u) => u ** (-1 / index));
      const found = tailIndex(all, spread);
      assert.ok(Math.abs(found / index - 1) < 0.3, `${found} of ${index}`);
    }
  });

  it('is beyond any power where errors are bounded', () => {
    const { all, spread } = pictures((u) => u);
    assert.ok(tailIndex(all, spread) > 10);
  });

  it('leaves noise what it is', () => {
    const { spread } = pictures((u) => u);
    const mean = 1.5;
    assert.ok(Math.abs(relativeNoise(spread, spread) / Math.sqrt(1 / 12 / (mean ** 2 + 0.01)) - 1) < 0.02);
  });
});

describe('the pixels that hold the noise', () => {
  /** Two pictures of black pixels, each channel off by as much as it is told. */
  function twoPictures(errors: readonly number[]): Spread {
    const spread = new Spread(3 * errors.length);
    for (const sign of [-1, 1])
      spread.add(Float32Array.from({ length: spread.length }, (_, i) => sign * (errors[Math.floor(i / 3)] as number)));
    return spread;
  }

  it('are all where all have equally much, and those that have any where others have none', () => {
    for (const [errors, count] of [
      [[1, 1, 1, 1, 1], 5],
      [[0, 2, 0, 0, 2], 2],
      [[0, 0, 7], 1],
    ] as const) {
      const spread = twoPictures(errors);
      assert.ok(Math.abs(noisyPixels(spread, spread) - count) < 1e-9);
    }
  });

  it('are about one where one has nearly all of it', () => {
    const spread = twoPictures([0.1, 0.1, 10, 0.1]);
    assert.ok(noisyPixels(spread, spread) < 1.01);
  });
});

describe('the front', () => {
  const choices = [choice(4, 0.1), choice(1, 0.5), choice(2, 0.6), choice(8, 0.1), choice(16, 0.01)];

  it('is what nothing beats in both', () => {
    assert.deepEqual(
      frontOf(choices).map(({ milliseconds }) => milliseconds),
      [1, 4, 16],
    );
  });

  it('forgives a tenth', () => {
    assert.deepEqual(beating(choice(4.3, 0.5), choices), []);
    assert.deepEqual(beating(choice(4.5, 0.5), choices), [choice(4, 0.1)]);
  });

  it('adds noise and bias, and knows samples that were not drawn by the root of how many more they are', () => {
    const point = { samples: 4096, noise: 0.04, noiseOfAll: 1, rareShare: 0, psnr: 1, flip: 0 };
    const found = sceneChoices({ settings: [measured({ msPerSample: 2, points: [point], bias: 0.03 })] });
    assert.deepEqual(
      found.map(({ samples, milliseconds, error, measured: drawn }) => [samples, milliseconds, error, drawn]),
      [
        [4096, 8192, 0.05, true],
        [16_384, 32_768, Math.hypot(0.02, 0.03), false],
      ],
    );
  });

  it('is drawn as a picture that stands by itself', () => {
    const svg = plotTrade(choices);
    assert.match(svg, /^<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    assert.ok(!/NaN|undefined/.test(svg));
  });
});

describe('the report', () => {
  const settings = [
    measured({ setting: { ...BASE, bounces: 6 }, timeRatios: [1, 1, 1, 1, 1], bias: 0.004, biasAtMost: 0.005 }),
    measured({ knob: 'integrator', setting: { ...BASE, integrator: 'direct' }, bias: 0.5, biasAtMost: 0.5 }),
    measured({ knob: 'bounces', setting: { ...BASE, bounces: 5 }, timeRatios: [0.5, 0.8, 0.8, 0.8, 2], bias: 0.02 }),
    measured({
      knob: 'bounces',
      setting: { ...BASE, bounces: 7 },
      timeRatios: [1, 1.1, 1.2, 1.3, 1.4],
      biasAtMost: 0.003,
    }),
  ];
  const trade = { one: { converged: { samples: 16, runs: 8, noise: 0.1 }, settings } };

  it('compares the times of one number of bounces and the next round by round', () => {
    const text = sceneSection('one', trade.one, 'one.svg');
    assert.match(text, /\| 5 → 6 \| \+25 % ± 0 % \| 2\.0 % → 0\.4 % \|/);
    assert.match(text, /\| 6 → 7 \| \+20 % ± 10 % \| 0\.4 % → ≤ 0\.3 % \|/);
    assert.ok(!/NaN|undefined/.test(text));
  });

  it('tells in a sentence what one more bounce changes', () => {
    assert.match(bounceFromBase(trade), /the 6\s.*by \+20 %, and the bias from 0\.4 % to < 0\.01 %/s);
    assert.deepEqual(galleryBounces(trade)[0], ['5 → 6', '+25 %', '2.0 % → 0.4 %', '0.4 % (one)']);
  });
});

describe('what the bench can be asked for', () => {
  it('is told with every option', () => {
    assert.ok(readOptions(['--help']).help);
    for (const name of [
      'only',
      'scene',
      'engine',
      'quick',
      'json',
      'from',
      'report',
      'presets',
      'frames',
      'max-error',
      'primitives',
      'help',
    ]) {
      assert.ok(USAGE.includes(`--${name}`), name);
    }
  });

  it('is, without a wish, also what shapes cost', () => {
    assert.deepEqual(readOptions([]).parts, ['scenes', 'trade', 'calibration', 'primitives']);
    assert.deepEqual(readOptions(['--scene', 'classic']).parts, ['scenes', 'trade', 'calibration']);
  });

  it('is refused in words where it cannot be done', () => {
    assert.throws(() => readOptions(['--only', 'speed']), /--only takes scenes, trade, calibration, .*, not speed/);
    assert.throws(() => readOptions(['--quick', '--report']), /need the trade of all scenes/);
    assert.throws(() => readOptions(['--fast']), /--fast/);
  });
});
