import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { hash } from '../../packages/core/src/random.ts';
import { relativeNoise, tailIndex } from '../bench/calibration/tail.ts';
import { readOptions, USAGE } from '../bench/options.ts';
import { beating, type Choice, frontOf, sceneChoices } from '../bench/trade/front.ts';
import { BASE, type Setting } from '../bench/trade/knobs.ts';
import type { Measured } from '../bench/trade/measure.ts';
import { plotTrade } from '../bench/trade/plots.ts';
import { biasOf, noiseOf, psnr, Spread } from '../bench/trade/statistics.ts';
import { normalRandom } from './normal-random.ts';

const NUMBERS = 3 * 2000;

/** Pictures of one grey, off by a constant, each number with normal noise. */
function pictures(count: number, { mean, deviation }: { mean: number; deviation: number }, seed: number): Spread {
  const random = normalRandom(seed);
  const spread = new Spread(NUMBERS);
  for (let i = 0; i < count; i++) {
    spread.add(Float32Array.from({ length: NUMBERS }, () => mean + deviation * random()));
  }
  return spread;
}

describe('the statistics of the trade', () => {
  const right = pictures(8, { mean: 1, deviation: 0.02 }, 1).converged();

  it('tell noise apart from bias', () => {
    const spread = pictures(6, { mean: 1.05, deviation: 0.2 }, 2);
    const { noise } = noiseOf(spread, right);
    const { bias, biasAtMost } = biasOf(spread, right);
    assert.ok(Math.abs(noise / (0.2 / Math.sqrt(1.01)) - 1) < 0.03, `${noise}`);
    assert.ok(Math.abs(bias / (0.05 / Math.sqrt(1.01)) - 1) < 0.1, `${bias}`);
    assert.ok(biasAtMost > bias);
  });

  it('find no more bias than chance allows where there is none', () => {
    const { bias, biasAtMost } = biasOf(pictures(6, { mean: 1, deviation: 0.2 }, 3), right);
    assert.ok(bias < biasAtMost && biasAtMost < 0.04, `${bias} ${biasAtMost}`);
  });

  it('tell of a picture most of whose variance is in a few pixels', () => {
    const random = normalRandom(4);
    const spread = new Spread(NUMBERS);
    for (let i = 0; i < 6; i++) {
      spread.add(Float32Array.from({ length: NUMBERS }, (_, j) => 1 + (j < 6 ? 1000 : 0.1) * random()));
    }
    const { noise, noiseOfAll, rareShare } = noiseOf(spread, right);
    assert.ok(rareShare > 0.99 && noiseOfAll > 10 && Math.abs(noise - 0.1) < 0.01, `${noise} ${noiseOfAll}`);
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

  it('knows that paths of more bounces leave out no more light', () => {
    const measured = (change: Partial<Setting>, bias: number): Measured => ({
      name: '',
      knob: 'bounces',
      setting: { ...BASE, ...change },
      shaderChars: 1,
      compileMs: 1,
      firstFrameMs: 1,
      msPerSample: 1,
      msSpread: 0,
      msPerFrame: 1,
      msPerFrameSpread: 0,
      seeds: 2,
      points: [{ samples: 16, noise: 0, noiseOfAll: 0, rareShare: 0, psnr: 1, flip: 0 }],
      bias,
      biasAtMost: 1,
    });
    const settings = [
      measured({ bounces: 16 }, 0.3),
      measured({ bounces: 2 }, 0.5),
      measured({ bounces: 6 }, 0.1),
      measured({ bounces: 16, clamp: 1 }, 0.4),
      measured({ bounces: 64, integrator: 'direct' }, 0.6),
    ];
    const errors = sceneChoices({ settings }).filter(({ samples }) => samples === 16);
    assert.deepEqual(
      errors.map(({ error }) => error),
      [0.1, 0.5, 0.1, 0.4, 0.6],
    );
  });

  it('is drawn as a picture that stands by itself', () => {
    const svg = plotTrade(choices);
    assert.match(svg, /^<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    assert.ok(!/NaN|undefined/.test(svg));
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
