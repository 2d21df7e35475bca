/** `docs/what-accuracy-costs.md`, as text. */

import { FEWEST_SAMPLES } from '../../../packages/ray-scene/src/stop-rules.ts';
import { type Calibration, hasVariance, isRight, LEAST_PIXELS } from '../calibration/calibration.ts';
import { biasOf, chanceOf, type Governed, stoppingOf } from '../governed.ts';
import { type Choice, fastestWithin, frontOf, galleryChoices, sceneChoices } from './front.ts';
import type { SceneTrade, Trade } from './measure.ts';
import { isForPages, PROMISED, type Preset } from './presets.ts';
import { bounceFromBase, galleryBounces, sceneSection } from './scene-section.ts';
import type { TradeNumbers } from './trade.ts';
import { ms, percent, table } from './words.ts';

export interface TradeReport extends TradeNumbers {
  readonly presets: readonly Preset[];
}

/** The error that the fastest setting is looked for within. */
const ASKED = 0.02;
/** @param plotOf where the picture of a scene is, or that of all of them. */
export function reportText(report: TradeReport, plotOf: (scene?: string) => string): string {
  const { trade } = report;
  return [
    introduction(report),
    gallerySection(report, plotOf()),
    fastestSection(trade),
    ...(report.calibration ? [calibrationSection(report.calibration)] : []),
    ...(report.stopping ? [stoppingSection(report.stopping)] : []),
    ...Object.entries(trade).map(([name, scene]) => sceneSection(name, scene, plotOf(name))),
    '',
  ].join('\n\n');
}

const introduction = ({ machine }: TradeReport): string => `# What accuracy costs

Written by \`npm run bench -- --report\`, and never by hand. ${machine.processor}, ${machine.cores} cores;
${machine.renderer}; pictures of 96 × 64. Times are of that machine: compare them with each other. They are
${machine.sampleTimes === 'cpu' ? 'what all processors spent together' : 'time on the clock'}.

Three questions, and where they are answered:

- What does one more bounce cost and buy? [In all scenes together](#what-does-one-more-bounce-cost-and-buy), and in the section
  of each scene.
- [Which preset am I on?](#which-preset-am-i-on)
- [What is the fastest setting under ${100 * ASKED} %?](#the-fastest-setting-under-${100 * ASKED}-)

The words:

- **Noise** is what differs between pictures with other random numbers: the root of the mean over pixels and channels of
  variance / (mean² + 0.01), which is what \`stats.error\` estimates. It is measured from several pictures.
- **Bias** is what stays when noise is averaged away: the same measure of the difference to \`path\` with 64 bounces. Where a
  setting draws the same paths as that, but for what it leaves out or weighs differently, both are drawn with the same random
  numbers, and what they differ by is far less noisy than either picture. Else it is the difference to a converged picture. In
  both, products of errors of pictures with other random numbers are averaged, in which noise is as often below 0 as above.
  "≤" where chance might be all of it: two standard errors.
- **Error** is both together, the root of the sum of their squares. Some pixels are left out of these three, the same ones for
  all settings of a scene: the half percent whose variance is largest by \`path\`, and as many by \`direct\`, both in converged
  pictures that serve for nothing else. A highlight much smaller than a pixel is met by one sample in thousands, and would be
  all that the numbers tell. The error is relative to what is right in each pixel: where fewer pixels spread a highlight over its
  dark neighbours, it is large, although it is hardly seen, as FLIP tells.
- **Time** is that of a sample over that of a sample by the first setting. All settings take turns, each between two turns of the
  first one, and each turn is divided by the mean of those two. What is told is the median of these ratios; behind ± is how far
  the middle half of them is from it: less than that is no difference. Milliseconds are the ratio times the median of the
  first setting, for pictures of 96 × 64; they grow in proportion to the number of pixels.
- PSNR and FLIP compare one picture, as it is shown without a tone curve, with the converged one. FLIP (Andersson et al. 2020)
  is 0 for alike, 1 for as different as can be; it is that of pictures seen at 67 pixels per degree.
- The **front** is the settings that nothing beats in time and error both. A **\\*** marks samples that were not drawn in all
  scenes, and a ring in the plots: their noise is that of the most that were, over the root of how many times more they are.
- Knobs are turned one at a time from where \`balanced\` stands: path, 6 bounces, roulette from the 4th surface on, all
  pixels, float targets, lights chosen by what they may contribute. Roulette and the choice of lights are not for pages to choose,
  nor is the target. A frame is one sample, shown.`;

function gallerySection({ trade, presets }: TradeReport, plot: string): string {
  const choices = galleryChoices(trade);
  const rows = presets.map(({ quality, given, standing, agrees }) => [
    `\`${quality}\``,
    given.integrator,
    given.bounces,
    given.samples,
    given.maxError === undefined ? '' : percent(given.maxError),
    standing ? `${ms(standing.milliseconds)}${star(standing)}` : '',
    standing ? percent(standing.error) : '',
    percent(PROMISED[quality]),
    agrees ? 'yes' : '**no**',
  ]);
  const front = frontOf(choices).map((choice) => [
    choice.name,
    `${choice.samples}${star(choice)}`,
    ms(choice.milliseconds),
    percent(choice.error),
  ]);
  return `## All scenes together

Geometric means of the times and of the errors of ${Object.keys(trade).length} scenes.

![Time against error of all scenes together](${plot})

### Which preset am I on?

What \`quality\` stands for: the fastest setting that a page can ask for with the promised error, to a tenth of the time; and no
setting at all that was measured beats it by more than a tenth in both time and error. The promised errors themselves
are no finding: they are round numbers, set by hand after an earlier measurement of these same scenes.
A page that says nothing is on \`balanced\`. Those with a \`max-error\` end sooner where the noise is below it.

${table(['quality', 'integrator', 'bounces', 'samples', '`max-error`', 'ms', 'error', 'promised', 'kept, and the fastest'], rows)}

### What does one more bounce cost and buy?

By \`path\`: the medians of ${Object.keys(trade).length} scenes, and where the bias is largest. ${bounceFromBase(trade)}

${table(['bounces', 'time', 'bias', 'the largest'], galleryBounces(trade))}

### The front

${table(['setting', 'samples', 'ms', 'error'], front)}`;
}

function fastestSection(trade: Trade): string {
  const rows = Object.entries(trade).map(([name, scene]) => {
    const fastest = fastestWithin(sceneChoices(scene).filter(isForPages), ASKED);
    return fastest
      ? [name, fastest.name, `${fastest.samples}${star(fastest)}`, ms(fastest.milliseconds), percent(fastest.error)]
      : [name, `none of them: the best is ${bestOf(scene)}`, '', '', ''];
  });
  return `## The fastest setting under ${100 * ASKED} %

Of those that a page can ask for; clamping where it pays in that scene, and fewer pixels by \`pixel-ratio\`.

${table(['scene', 'setting', 'samples', 'ms', 'error'], rows)}`;
}

function bestOf(scene: SceneTrade): string {
  const best = frontOf(sceneChoices(scene).filter(isForPages)).at(-1) as Choice;
  return `${best.name} with ${percent(best.error)}`;
}

function calibrationSection(calibration: readonly Calibration[]): string {
  const ratio = (value: number): string => value.toFixed(2);
  const rows = calibration.map((row) => [
    row.scene,
    row.integrator,
    row.samples,
    percent(row.noise),
    `${ratio(row.ratio)}${isRight(row) ? '' : row.judged ? ' **!**' : ' !'}`,
    `${ratio(row.least)} to ${ratio(row.most)}`,
    `${row.tailIndex.toFixed(1)}${hasVariance(row) ? '' : ': not finite'}`,
    `${row.pixels.toFixed(0)}${row.pixels < LEAST_PIXELS ? ': too few' : ''}`,
  ]);
  const right = (some: readonly Calibration[]): string => `${some.filter(isRight).length} of ${some.length}`;
  return `## Does a picture know its noise?

What \`stats.error\` said over what the noise was: the middle of several pictures, and the range of them. It is to be within 0.8
and 1.25 where the variance is finite. It is so in ${right(calibration.filter(hasVariance))} such cases, in ${right(calibration.filter(({ judged }) => judged))} of those in which the noise
is not that of a few pixels, and in ${right(calibration)} of all.

Whether the variance is finite is not seen from the estimates, but from how fast large errors become rare: where one larger than
x has a probability in proportion to x^-α, α must be above 2. It is estimated (Hill 1975) from the √n largest errors of all
pixels of all pictures with the most samples. Where it is 2 or less, pictures in which a rare path has not been met cannot know
of it: they say less than there is until it is met.

How many pixels hold the noise is (Σ v)² / Σ v² of their true relative variances v. An estimate has one degree of freedom for
each of them: where they are fewer than ${LEAST_PIXELS.toFixed(1)}, chance alone takes it beyond the limits, and the truth as well, of which so few
pictures are known. So it is where the corner of a lamp is a two-hundredth of one pixel.

Pictures by \`direct\` have their samples in the same places of all pixels, so that one picture's error along edges is one draw,
not the mean of many: the middle is right, and single pictures are off by what the range says.

${table(['scene', 'integrator', 'samples', 'noise', 'estimated / true', 'range', 'tail index', 'pixels'], rows)}`;
}

function stoppingSection(stopping: readonly Governed[]): string {
  const rows = stopping.map((row) => [
    row.scene,
    percent(row.maxError),
    `${row.width} × ${row.height}`,
    row.evenSamples.toFixed(0),
    row.adaptedSamples.toFixed(0),
    row.timeRatio.toFixed(2),
    row.cpuRatio.toFixed(2),
    row.equalRatio.toFixed(2),
    row.evenNoise.toFixed(2),
    row.adaptedNoise.toFixed(2),
    `${biasOf(row).toFixed(2)} ± ${chanceOf(row).toFixed(2)}`,
    row.reasons.join(', '),
  ]);
  const asked = [...new Set(stopping.map(({ maxError }) => maxError))];
  return `## What comes of \`max-error\`

Pictures that end when they say that their noise is what was asked, or with the samples that were allowed. With it, samples go
where the error is from the ${FEWEST_SAMPLES + 1}th on: their mean over the pixels is beside that of pictures in which they do not. The times are
over those of such pictures: that of the GPU on the clock, that which all processors spent, and the latter as if both had ended
with the same true noise. Noise and bias are told over the error that was asked for. The noise is that which several pictures
have between them; the bias is by how much adapted pictures differ in the mean from others with the same random numbers, which
stop by the same rule, and behind it stands what chance alone makes of none. Pictures are as large as one of them takes no
longer than a minute: cells of 16 × 16 pixels are more alike the fewer they are.

${asked.map((error) => stoppingSummary(stopping.filter(({ maxError }) => maxError === error))).join('\n')}

${table(['scene', 'asked', 'pixels', 'samples', 'adapted', 'GPU time', 'CPU time', 'for equal noise', 'noise', 'adapted', 'bias', 'end'], rows)}`;
}

function stoppingSummary(rows: readonly Governed[]): string {
  const { times, near, early, below, above, bias, biasAtMost } = stoppingOf(rows);
  const [gpu, cpu, equal] = times.map((time) => time.toFixed(2));
  return `- Asked for ${percent(rows[0]?.maxError ?? 0)}, ${rows.length} scenes: the medians are ${gpu} of the GPU's time, ${cpu} of the
  processors', and ${equal} for equal noise. The true noise is within a quarter of what was asked in ${near}; in ${early} the fewest
  samples that are ever drawn are enough, and it is below. The bias is below a tenth of what was asked by two standard errors
  in ${below}, above it by two in ${above}; of all scenes together (the root of the mean of the squares) it is ${bias.toFixed(2)}, and at
  most ${biasAtMost.toFixed(2)}.`;
}

const star = ({ measured }: Choice): string => (measured ? '' : ' \\*');
