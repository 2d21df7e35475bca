/** What each setting costs and buys in a scene, and what each further bounce does, as text. */
import { BASE } from './knobs.ts';
import type { Measured, SceneTrade, Trade } from './measure.ts';
import { typical } from './statistics.ts';
import { ms, percent, signed, table } from './words.ts';

/** Of how many samples the tables of settings speak. */
const SHOWN_SAMPLES = 16;

/** @param plot where its picture is. */
export function sceneSection(name: string, scene: SceneTrade, plot: string): string {
  const { settings, converged } = scene;
  return `## ${name}

![Time against error of ${name}](${plot})

Held to ${converged.samples} samples in ${converged.runs} pictures, whose mean has a noise of ${percent(converged.noise)}.

${bouncesText(settings)}${table(
  [
    'setting',
    'time',
    'ms/sample',
    'ms/frame',
    `noise of ${SHOWN_SAMPLES}`,
    'bias',
    'PSNR',
    'FLIP',
    'first frame',
    'compile',
    'shader',
  ],
  settings.map(settingRow),
)}`;
}

function settingRow(one: Measured): readonly (string | number)[] {
  const { name, timeRatios, msPerSample, msPerFrame, firstFrameMs, compileMs, shaderChars } = one;
  const point = pointAt(one);
  const { median, spread } = typical(timeRatios);
  return [
    name,
    `× ${median.toFixed(2)} ± ${spread.toFixed(2)}`,
    ms(msPerSample),
    ms(msPerFrame),
    percent(point.noise),
    biasText(one),
    point.psnr.toFixed(1),
    point.flip.toFixed(3),
    ms(firstFrameMs),
    ms(compileMs),
    shaderChars,
  ];
}

/** Whether chance might be all of it is told. */
export const biasText = ({ bias, biasAtMost }: Pick<Measured, 'bias' | 'biasAtMost'>): string =>
  bias < biasAtMost / 2 ? `≤ ${percent(biasAtMost)}` : percent(bias);

const pointAt = ({ points }: Measured): Measured['points'][number] =>
  points.find(({ samples }) => samples === SHOWN_SAMPLES) ?? (points.at(-1) as Measured['points'][number]);

/** Of `path`, by their number. */
const bouncesOf = (settings: readonly Measured[]): readonly Measured[] =>
  settings
    .filter(({ knob, setting }) => knob === 'bounces' || (knob === 'none' && setting.integrator === 'path'))
    .sort((a, b) => a.setting.bounces - b.setting.bounces);

/** By how much more time a sample takes with one setting than with another: of each round. */
const moreTime = (next: Measured, before: Measured) =>
  typical(next.timeRatios.map((time, round) => time / (before.timeRatios[round] as number) - 1));

/** What each further bounce costs and buys. */
function bouncesText(settings: readonly Measured[]): string {
  const steps = bouncesOf(settings);
  const rows = steps.slice(1).map((next, i) => {
    const before = steps[i] as Measured;
    const { median, spread } = moreTime(next, before);
    return [
      `${before.setting.bounces} → ${next.setting.bounces}`,
      `${signed(median)} ± ${(100 * spread).toFixed(0)} %`,
      `${biasText(before)} → ${biasText(next)}`,
      `${percent(pointAt(before).noise)} → ${percent(pointAt(next).noise)}`,
    ];
  });
  if (rows.length === 0) return '';
  return `What bounces cost and buy by \`path\`:

${table(['bounces', 'time', 'bias', `noise of ${SHOWN_SAMPLES} samples`], rows)}

All settings:

`;
}

interface Step {
  readonly name: string;
  readonly before: Measured;
  readonly next: Measured;
}

/** From one number of bounces to the next, of all scenes. */
function stepsOf(trade: Trade): readonly (readonly Step[])[] {
  const scenes = Object.entries(trade).map(([name, { settings }]) => ({ name, steps: bouncesOf(settings) }));
  const [first] = scenes;
  return (first?.steps ?? [])
    .slice(1)
    .map((_, i) =>
      scenes.map(({ name, steps }) => ({ name, before: steps[i] as Measured, next: steps[i + 1] as Measured })),
    );
}

/** Medians. */
function middleOf(steps: readonly Step[]) {
  const middle = (of: (step: Step) => number): number => typical(steps.map(of)).median;
  return {
    from: steps[0]?.before.setting.bounces as number,
    to: steps[0]?.next.setting.bounces as number,
    time: signed(middle(({ next, before }) => moreTime(next, before).median)),
    bias: [percent(middle(({ before }) => before.bias)), percent(middle(({ next }) => next.bias))] as const,
  };
}

export const galleryBounces = (trade: Trade): readonly (readonly string[])[] =>
  stepsOf(trade).map((steps) => {
    const { from, to, time, bias } = middleOf(steps);
    const worst = steps.reduce((one, other) => (other.next.bias > one.next.bias ? other : one));
    return [`${from} → ${to}`, time, bias.join(' → '), `${percent(worst.next.bias)} (${worst.name})`];
  });

/** One bounce more than where the knobs are turned from. */
export function bounceFromBase(trade: Trade): string {
  const step = stepsOf(trade)
    .map(middleOf)
    .find(({ from, to }) => from === BASE.bounces && to === from + 1);
  if (!step) return '';
  return `One more than the ${step.from}
that pages have by default changes the time of a sample by ${step.time}, and the bias from ${step.bias[0]} to ${step.bias[1]}.`;
}
