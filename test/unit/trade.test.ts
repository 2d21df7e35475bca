import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { readOptions, USAGE } from '../bench/options.ts';
import { beating, type Choice, frontOf } from '../bench/trade/front.ts';
import { BASE } from '../bench/trade/knobs.ts';
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
      'primitives',
      'help',
    ]) {
      assert.ok(USAGE.includes(`--${name}`), name);
    }
  });

  it('is refused in words where it cannot be done', () => {
    assert.throws(() => readOptions(['--only', 'speed']), /--only takes scenes, trade, primitives, .*, not speed/);
    assert.throws(() => readOptions(['--quick', '--report']), /need the trade of all scenes/);
    assert.throws(() => readOptions(['--fast']), /--fast/);
  });
});
