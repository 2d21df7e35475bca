/** `docs/what-accuracy-costs.md`, as text. */
import { type Calibration, isRight } from '../calibration/calibration.ts';
import { biasOf, chanceOf, type Governed, stoppingOf } from '../governed.ts';
import { type Choice, fastestWithin, frontOf, galleryChoices, sceneChoices } from './front.ts';
import type { Measured, SceneTrade, Trade } from './measure.ts';
import { PROMISED, type Preset } from './presets.ts';
import type { TradeNumbers } from './trade.ts';

export interface TradeReport extends TradeNumbers {
  readonly presets: readonly Preset[];
}

/** The error that the fastest setting is looked for within. */
const ASKED = 0.02;
/** Of how many samples the tables of settings speak. */
const SHOWN_SAMPLES = 16;

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

- **Noise** is what differs between pictures with other random numbers: the root of the mean over pixels and channels of
  variance / (mean² + 0.01), which is what \`stats.error\` estimates. It is measured from several pictures.
- **Bias** is what stays when noise is averaged away: the same measure of the difference between the mean of those pictures and
  one by \`path\` with 64 bounces and very many samples. "≤" where chance might be all of it: two standard errors.
- **Error** is both together, the root of the sum of their squares. Half a percent of the pixels is left out of these three,
  those with the largest variance: a highlight much smaller than a pixel is met by one sample in thousands, and would be all
  that the numbers tell.
- PSNR and FLIP compare one picture, as it is shown without a tone curve, with the converged one. FLIP (Andersson et al. 2020)
  is 0 for alike, 1 for as different as can be; it is that of pictures seen at 67 pixels per degree.
- The **front** is the settings that nothing beats in time and error both. A **\\*** marks samples that were not drawn: their
  noise is that of the most that were, over the root of how many times more they are.
- Settings are turned one at a time from where \`balanced\` stands: path, 6 bounces, roulette from the 4th surface on, all
  pixels, float targets, lights chosen by what they may contribute. Roulette and the choice of lights are not for pages to choose. A frame
  is one sample, shown.`;

function gallerySection({ trade, presets }: TradeReport, plot: string): string {
  const choices = galleryChoices(trade);
  const rows = presets.map(({ quality, given, standing, agrees }) => [
    `\`${quality}\``,
    given.integrator,
    given.bounces,
    given.samples,
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
\`accurate\` and \`reference\` end sooner where \`max-error\` is reached.

${table(['quality', 'integrator', 'bounces', 'samples', 'ms', 'error', 'promised', 'kept, and the fastest'], rows)}

### The front

${table(['setting', 'samples', 'ms', 'error'], front)}`;
}

function fastestSection(trade: Trade): string {
  const rows = Object.entries(trade).map(([name, scene]) => {
    const fastest = fastestWithin(sceneChoices(scene), ASKED);
    return fastest
      ? [name, fastest.name, `${fastest.samples}${star(fastest)}`, ms(fastest.milliseconds), percent(fastest.error)]
      : [name, `none of them: the best is ${bestOf(scene)}`, '', '', ''];
  });
  return `## The fastest setting under ${percent(ASKED)}

${table(['scene', 'setting', 'samples', 'ms', 'error'], rows)}`;
}

function bestOf(scene: SceneTrade): string {
  const best = frontOf(sceneChoices(scene)).at(-1) as Choice;
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
    `${row.tailIndex.toFixed(1)}${row.judged ? '' : ': not finite'}`,
  ]);
  const right = (some: readonly Calibration[]): string => `${some.filter(isRight).length} of ${some.length}`;
  return `## Does a picture know its noise?

What \`stats.error\` said over what the noise was: the middle of several pictures, and the range of them. It is to be within 0.8
and 1.25 where the variance is finite. It is so in ${right(calibration.filter(({ judged }) => judged))} cases, and in ${right(calibration)} of all.

Whether the variance is finite is not seen from the estimates, but from how fast large errors become rare: where one larger than
x has a probability in proportion to x^-α, α must be above 2. It is estimated (Hill 1975) from the √n largest errors of all
pixels of all pictures with the most samples. Where it is 2 or less, pictures in which a rare path has not been met cannot know
of it: they say less than there is until it is met.

Pictures by \`direct\`, and edges in all of them, have their samples in the same places of all pixels, so that one picture's error
along edges is one draw, not the mean of many: the middle is right, and single pictures are off by what the range says.

${table(['scene', 'integrator', 'samples', 'noise', 'estimated / true', 'range', 'tail index'], rows)}`;
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
where the error is from the 16th on: their mean over the pixels is beside that of pictures in which they do not. The times are
over those of such pictures: that of the GPU on the clock, that which all processors spent, and the latter as if both had ended
with the same true noise. Noise and bias are told over the error that was asked for. The noise is that which several pictures have
between them; the bias is by how much adapted pictures differ in the mean from others, which stop by the same rule, and behind
it stands what chance alone makes of none.

${asked.map((error) => stoppingSummary(stopping.filter(({ maxError }) => maxError === error))).join('\n')}

${table(['scene', 'asked', 'pixels', 'samples', 'adapted', 'GPU time', 'CPU time', 'for equal noise', 'noise', 'adapted', 'bias', 'end'], rows)}`;
}

function stoppingSummary(rows: readonly Governed[]): string {
  const { times, near, early, below, above, bias, biasAtMost } = stoppingOf(rows);
  const [gpu, cpu, equal] = times.map((time) => time.toFixed(2));
  return `- Asked for ${percent(rows[0]?.maxError ?? 0)}, ${rows.length} scenes: the medians are ${gpu} of the GPU's time, ${cpu} of the processors', and ${equal} for equal
  noise. The true noise is within a quarter of what was asked in ${near}; in ${early} the fewest samples that are ever drawn are enough, and
  it is below. The bias is below a tenth of what was asked by two standard errors in ${below}, above it by two in ${above}; of all scenes together (the root of the mean of the squares) it is ${bias.toFixed(2)}, and
  at most ${biasAtMost.toFixed(2)}.`;
}

function sceneSection(name: string, scene: SceneTrade, plot: string): string {
  const { settings, converged } = scene;
  const base = settings[0] as Measured;
  return `## ${name}

![Time against error of ${name}](${plot})

Held to ${converged.samples} samples, whose noise is ${percent(converged.noise)}.

${bouncesText(settings)}${table(
  [
    'setting',
    'ms/sample',
    'ms/frame',
    'time',
    `noise of ${SHOWN_SAMPLES}`,
    'bias',
    'PSNR',
    'FLIP',
    'first frame',
    'compile',
    'shader',
  ],
  settings.map((one) => settingRow(one, base)),
)}`;
}

function settingRow(one: Measured, base: Measured): readonly (string | number)[] {
  const { name, msPerSample, msSpread, msPerFrame, bias, biasAtMost, points, firstFrameMs, compileMs, shaderChars } =
    one;
  const point = pointAt(one);
  return [
    name,
    `${ms(msPerSample)} ± ${ms(msSpread)}`,
    ms(msPerFrame),
    `× ${(msPerSample / base.msPerSample).toFixed(2)}`,
    percent(point.noise),
    bias < biasAtMost / 2 ? `≤ ${percent(biasAtMost)}` : percent(bias),
    point.psnr.toFixed(1),
    point.flip.toFixed(3),
    ms(firstFrameMs),
    ms(compileMs),
    shaderChars,
  ].map((cell) => (points.length > 0 ? cell : ''));
}

const pointAt = ({ points }: Measured): Measured['points'][number] =>
  points.find(({ samples }) => samples === SHOWN_SAMPLES) ?? (points.at(-1) as Measured['points'][number]);

/** What each further bounce costs and buys. */
function bouncesText(settings: readonly Measured[]): string {
  const steps = settings
    .filter(({ knob, setting }) => knob === 'bounces' || (knob === 'none' && setting.integrator === 'path'))
    .sort((a, b) => a.setting.bounces - b.setting.bounces);
  const rows = steps.slice(1).map((next, i) => {
    const before = steps[i] as Measured;
    return [
      `${before.setting.bounces} → ${next.setting.bounces}`,
      signed(next.msPerSample / before.msPerSample - 1),
      `${percent(before.bias)} → ${percent(next.bias)}`,
      `${percent(pointAt(before).noise)} → ${percent(pointAt(next).noise)}`,
    ];
  });
  if (rows.length === 0) return '';
  return `What bounces cost and buy:

${table(['bounces', 'time', 'bias', `noise of ${SHOWN_SAMPLES} samples`], rows)}

All settings:

`;
}

const star = ({ measured }: Choice): string => (measured ? '' : ' \\*');

const percent = (share: number): string => `${(100 * share).toFixed(share < 0.0995 ? 1 : 0)} %`;

const signed = (share: number): string => `${share < 0 ? '−' : '+'}${Math.abs(100 * share).toFixed(0)} %`;

const ms = (time: number): string => (time < 10 ? time.toFixed(2) : time < 100 ? time.toFixed(1) : time.toFixed(0));

const table = (head: readonly string[], rows: readonly (readonly (string | number)[])[]): string =>
  [head, head.map((_, i) => (i === 0 ? '---' : '---:')), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');
