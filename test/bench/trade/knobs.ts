/** The settings that the trade is measured at: one knob turned at a time, from where `balanced` stands. */

export interface Setting {
  readonly integrator: 'path' | 'direct';
  readonly bounces: number;
  /** How many surfaces a path meets before roulette may end it. */
  readonly roulette: number;
  /** Pixels per pixel that is shown, along each side. */
  readonly scale: number;
  readonly target: 'float' | 'half';
  /** How the one light is chosen that is asked: by what it may contribute, or all of them alike. */
  readonly lights: 'power' | 'uniform';
  /** Radiance above which samples are dimmed. */
  readonly clamp?: number;
}

export type Knob = keyof Setting;

export interface Variant {
  readonly name: string;
  /** What differs from `BASE` first of all. */
  readonly knob: Knob | 'none';
  readonly setting: Setting;
  /** Samples per pixel at which it is looked at. */
  readonly samples: readonly number[];
}

/** More than any number of bounces: no roulette. */
const NEVER = 64;

export const BASE: Setting = {
  integrator: 'path',
  bounces: 6,
  roulette: 3,
  scale: 1,
  target: 'float',
  lights: 'power',
};

/** What a picture converges to. */
export const CONVERGED: Setting = { ...BASE, bounces: 64 };

/** Samples of the pictures that are compared with ones of the same random numbers. */
export const PAIRED = 16;

/**
 * Whether a setting follows the same paths as the converged one, but for what it leaves out or weighs differently: then with
 * the same random numbers the two differ by that alone, and its bias is known far better than either picture.
 */
export const isPaired = ({ integrator, scale }: Setting): boolean =>
  integrator === CONVERGED.integrator && scale === CONVERGED.scale;

/** By Whitted ray tracing, as `draft` does. */
export const DIRECT: Setting = { ...BASE, integrator: 'direct', bounces: 4 };

const FEW = [1, 4, PAIRED] as const;
/** Of the settings that a `quality` stands for. */
const MANY = [...FEW, 64, 256] as const;

const variant = (
  name: string,
  knob: Variant['knob'],
  change: Partial<Setting>,
  samples: readonly number[] = FEW,
): Variant => ({ name, knob, setting: { ...BASE, ...change }, samples });

/** The first is what the times of all others are compared with, and the first two are those that `--quick` measures. */
export const VARIANTS: readonly Variant[] = [
  variant('path, 6 bounces', 'none', {}, MANY),
  variant('direct, 4 bounces', 'integrator', DIRECT, MANY),
  variant('direct, 1 bounce', 'integrator', { integrator: 'direct', bounces: 1 }),
  ...[1, 2, 3, 4, 5, 7, 8, 16, 64].map((bounces) =>
    variant(`path, ${bounces} bounce${bounces === 1 ? '' : 's'}`, 'bounces', { bounces }, bounces === 16 ? MANY : FEW),
  ),
  variant('roulette from the 2nd surface', 'roulette', { roulette: 1 }),
  variant('roulette from the 6th surface', 'roulette', { roulette: 5 }),
  variant('no roulette', 'roulette', { roulette: NEVER }),
  variant('a quarter of the pixels', 'scale', { scale: 0.5 }),
  variant('direct, a quarter of the pixels', 'scale', { ...DIRECT, scale: 0.5 }),
  variant('half-float target', 'target', { target: 'half' }),
  variant('clamp at 1', 'clamp', { clamp: 1 }),
  variant('clamp at 10', 'clamp', { clamp: 10 }),
  variant('all lights alike', 'lights', { lights: 'uniform' }),
];

export const QUICK_VARIANTS: readonly Variant[] = VARIANTS.slice(0, 2);
