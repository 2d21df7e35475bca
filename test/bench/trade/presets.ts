/** Chooses what `quality` stands for from what was measured, and compares it with what `settings.ts` says. */
import { parseSettings, qualities, type RenderSettings } from '@ray-scene/core';
import { beating, type Choice, fastestWithin, galleryChoices, MARGIN } from './front.ts';
import { BASE } from './knobs.ts';
import type { Trade } from './measure.ts';

export type Quality = RenderSettings['quality'];

/**
 * The error, over the gallery as a whole, that each is to stay below: round numbers, set by hand after an earlier measurement
 * of the same scenes. Each quality is the fastest of all settings which a page can ask for that does.
 */
export const PROMISED: { readonly [Q in Quality]: number } = {
  draft: 0.15,
  balanced: 0.02,
  accurate: 0.01,
  reference: 0.005,
};

export interface Preset {
  readonly quality: Quality;
  /** What `settings.ts` says: what of it is a point of the trade. */
  readonly given: Pick<RenderSettings, 'integrator' | 'bounces' | 'samples' | 'maxError'>;
  readonly standing: Choice | undefined;
  readonly chosen: Choice | undefined;
  /** What is better than what is given by more than a tenth in both. */
  readonly beatenBy: readonly Choice[];
  readonly agrees: boolean;
}

/** Whether the settings of an element can ask for it: they say no more of how samples are drawn. */
export const isForPages = ({ setting: { roulette, target, lights } }: Choice): boolean =>
  roulette === BASE.roulette && target === BASE.target && lights === BASE.lights;

/** `clamp` is a radiance that is none of any scene but the one it is chosen for, and `pixelRatio` is that of the screen. */
const isOffered = (choice: Choice): boolean =>
  isForPages(choice) && choice.setting.scale === BASE.scale && choice.setting.clamp === undefined;

const isSame = ({ setting, samples }: Choice, given: Preset['given']): boolean =>
  setting.integrator === given.integrator && setting.bounces === given.bounces && samples === given.samples;

export function presetsOf(trade: Trade): readonly Preset[] {
  const choices = galleryChoices(trade);
  const offered = choices.filter(isOffered);
  return (Object.keys(qualities) as Quality[]).map((quality) => {
    const given = parseSettings({ quality });
    const standing = offered.find((choice) => isSame(choice, given));
    const chosen = fastestWithin(offered, PROMISED[quality]);
    const beatenBy = standing ? beating(standing, choices) : [];
    const isKept = !!standing && standing.error <= PROMISED[quality];
    const isFastest = !!standing && !!chosen && standing.milliseconds <= MARGIN * chosen.milliseconds;
    const agrees = isKept && isFastest && beatenBy.length === 0;
    return { quality, given, standing, chosen, beatenBy, agrees };
  });
}

const named = ({ setting: { integrator, bounces }, samples }: Choice): string =>
  `${integrator}, ${bounces} bounces, ${samples} samples`;

/** Prints the choice; returns whether `settings.ts` agrees. */
export function printPresets(presets: readonly Preset[]): boolean {
  for (const { quality, given, standing, chosen, beatenBy, agrees } of presets) {
    const percent = (choice: Choice): string => `${(100 * choice.error).toFixed(1)} %`;
    console.log(`\n${quality}, below ${100 * PROMISED[quality]} %:`);
    console.log(
      `  settings.ts: ${given.integrator}, ${given.bounces} bounces, ${given.samples} samples: ${standing ? percent(standing) : 'not measured'}`,
    );
    console.log(`  the fastest: ${chosen ? `${named(chosen)}: ${percent(chosen)}` : 'none'}`);
    for (const better of beatenBy) console.log(`  beaten by ${better.name}, ${better.samples} samples`);
    console.log(`  ${agrees ? 'kept, and the fastest' : 'NOT KEPT, OR NOT THE FASTEST'}`);
  }
  return presets.every(({ agrees }) => agrees);
}
