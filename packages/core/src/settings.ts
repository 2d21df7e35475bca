/** How a scene is rendered, as opposed to what it is: the same kind of table as the scene's own. */
import { choice, Mismatch, number, type Values } from './fields.ts';
import { say } from './say.ts';
import { SceneError } from './scene-error.ts';

export const settingsFields = {
  quality: choice(
    'Where between fast and right the settings below stand that are not given; each is a set of them.',
    ['draft', 'balanced', 'accurate', 'reference'],
    { default: 'balanced' },
  ),
  integrator: choice(
    'How light is followed; path: all of its ways; direct: Whitted ray tracing, free of noise under point lights.',
    ['path', 'direct'],
    { default: 'path' },
  ),
  bounces: number('Surfaces that light may meet on its way, one after the other.', {
    default: 6,
    min: 0,
    max: 64,
    integer: true,
  }),
  samples: number('Samples per pixel after which the picture is complete.', {
    default: 256,
    min: 1,
    max: 2 ** 20,
    integer: true,
  }),
  maxError: number('Noise below which the picture is complete, measured as `stats.error` is; none: not asked for.', {
    above: 0,
    max: 1,
  }),
  maxTime: number('Seconds after which the picture is complete; none: as long as it takes.', { above: 0, max: 1e6 }),
  frameBudget: number('Time that rendering may take of each frame, in milliseconds.', {
    default: 12,
    min: 1,
    max: 1000,
  }),
  pixelRatio: number('Device pixels per CSS pixel; default: those of the screen.', { above: 0, max: 16 }),
  clamp: number('Radiance above which a sample of a path is dimmed, but for what is seen itself; none: no bias.', {
    above: 0,
  }),
  exposure: number('Linear factor on the radiance before tone mapping.', { default: 1, min: 0 }),
  toneMapping: choice('neutral: Khronos PBR Neutral; none: clipped. Both then encode sRGB.', ['neutral', 'none'], {
    default: 'neutral',
  }),
  output: choice(
    'What is shown; normal: of the first surface, 0.5 n + 0.5; depth: how near it is, 1 / (1 + t / T), T being the distance in focus; albedo: its base colour; error: how noisy the picture is, dark 0.1 %, bright 100 %; samples: where there are most.',
    ['beauty', 'normal', 'depth', 'albedo', 'error', 'samples'],
    { default: 'beauty' },
  ),
  seed: number('Start of the random numbers.', { default: 0, min: 0, max: 2 ** 32 - 1, integer: true }),
} as const;

export type RenderSettings = Values<typeof settingsFields>;

/** What each quality puts in the place of defaults; `balanced` is these themselves. */
export const qualities: { readonly [Q in RenderSettings['quality']]: Partial<RenderSettings> } = {
  draft: { integrator: 'direct', bounces: 4, samples: 4 },
  balanced: {},
  accurate: { bounces: 16, samples: 1024, maxError: 0.01 },
  reference: { bounces: 16, samples: 4096, maxError: 0.002 },
};

/** The settings with the defaults of a quality, by its name. */
export const settingsOf = (quality: unknown): typeof settingsFields => {
  const preset = (qualities as { readonly [name: string]: { readonly [name: string]: unknown } })[quality as string];
  return Object.fromEntries(
    Object.entries(settingsFields).map(([name, field]) => [
      name,
      { ...field, default: preset?.[name] ?? field.default },
    ]),
  ) as typeof settingsFields;
};

/**
 * Fills in the defaults of the settings that are not given.
 * @throws {SceneError} when one is unknown or out of its range.
 */
export function parseSettings(given: { readonly [name: string]: unknown } = {}): RenderSettings {
  const fields = Object.entries(settingsOf(given.quality));
  const names = fields.map(([name]) => name);
  const problems = Object.keys(given)
    .filter((name) => !names.includes(name))
    .map((name) => problem(name, say('unknownSetting', name, names)));
  const values = fields.map(([name, field]) => {
    const value = given[name] === undefined ? field.default : field.read(given[name]);
    if (value instanceof Mismatch) problems.push(problem(name, value.sentence(name, given[name])));
    return [name, value];
  });
  if (problems.length > 0) throw new SceneError(problems);
  return Object.fromEntries(values.filter(([, value]) => value !== undefined)) as RenderSettings;
}

const problem = (name: string, message: string) => ({ path: [name], where: 'settings', message });
