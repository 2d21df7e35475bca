/** What of all that was measured is worth its time, scene by scene and for the gallery as a whole. */
import type { Setting } from './knobs.ts';
import type { Measured, SceneTrade, Trade } from './measure.ts';

/** A setting with so many samples. */
export interface Choice {
  readonly name: string;
  readonly setting: Setting;
  readonly samples: number;
  /** Of the whole picture of the bench. */
  readonly milliseconds: number;
  /** Noise and bias together: the root of the sum of their squares. */
  readonly error: number;
  /** Whether there were pictures with so many samples, or their noise is that of fewer over the root of how many more. */
  readonly measured: boolean;
}

/** Nobody sees less, and a scene without noise is not better than others without bounds. */
const LEAST_ERROR = 0.001;
const MOST_SAMPLES = 16_384;

function choicesOf({ name, setting, msPerSample, bias, points }: Measured): readonly Choice[] {
  const last = points.at(-1) as Measured['points'][number];
  const further: { samples: number; noise: number }[] = [];
  for (let samples = 4 * last.samples; samples <= MOST_SAMPLES; samples *= 4) {
    further.push({ samples, noise: last.noise * Math.sqrt(last.samples / samples) });
  }
  return [...points, ...further].map(({ samples, noise }) => ({
    name,
    setting,
    samples,
    milliseconds: samples * msPerSample,
    error: Math.max(Math.hypot(noise, bias), LEAST_ERROR),
    measured: samples <= last.samples,
  }));
}

export const sceneChoices = ({ settings }: Pick<SceneTrade, 'settings'>): readonly Choice[] =>
  settings.flatMap(choicesOf);

/**
 * The same of all scenes together: geometric means, so that a scene which takes ten times as long or is ten times as noisy
 * counts as much as any other.
 */
export function galleryChoices(trade: Trade): readonly Choice[] {
  const scenes = Object.values(trade).map(sceneChoices);
  const [first = []] = scenes;
  const mean = (values: readonly number[]): number =>
    Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
  return first.map((choice, i) => ({
    ...choice,
    milliseconds: mean(scenes.map((choices) => (choices[i] as Choice).milliseconds)),
    error: mean(scenes.map((choices) => (choices[i] as Choice).error)),
    measured: scenes.every((choices) => (choices[i] as Choice).measured),
  }));
}

/** Those that nothing beats in time and error both, the fastest first. */
export function frontOf(choices: readonly Choice[]): readonly Choice[] {
  const sorted = [...choices].sort((a, b) => a.milliseconds - b.milliseconds || a.error - b.error);
  let best = Number.POSITIVE_INFINITY;
  return sorted.filter(({ error }) => {
    if (error >= best) return false;
    best = error;
    return true;
  });
}

/** How much worse in both a choice may be than another before it is said to be beaten. */
export const MARGIN = 1.1;

/** What is better than a choice by more than a tenth in time and in error. */
export const beating = (choice: Choice, choices: readonly Choice[]): readonly Choice[] =>
  choices.filter(
    ({ milliseconds, error }) => MARGIN * milliseconds < choice.milliseconds && MARGIN * error < choice.error,
  );

/** The fastest with no more error, if there is one. */
export const fastestWithin = (choices: readonly Choice[], error: number): Choice | undefined =>
  frontOf(choices).find((choice) => choice.error <= error);
