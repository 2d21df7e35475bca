/** What `npm run bench` can be asked for. */
import { parseArgs } from 'node:util';
import { ENGINES } from '../browsers.mjs';

/** What is measured; without a wish the first four are. */
export const PARTS = [
  'scenes',
  'trade',
  'calibration',
  'primitives',
  'convergence',
  'adaptive',
  'frames',
  'features',
] as const;
export type Part = (typeof PARTS)[number];

export const USAGE = `npm run bench -- [options]

Measures how long scenes take, and what each setting costs and buys.

  --only scenes       time to the first picture and for each sample of the example scenes, against shaders by hand
  --only trade        each example scene with each setting: time, noise, bias, PSNR, FLIP
  --only calibration  whether pictures know their noise: examples by both integrators, and scenes of the truth
  --only primitives   shapes of each kind by the engine's formulas and by those of textbooks; also --primitives
  --only convergence  how fast the noise of paths goes down in each example; also --convergence
  --only adaptive     what it brings that samples go where the error is, its bias, and the noise at the stop; also --adaptive
  --only frames       whether work keeps to the budget of a frame while the camera is dragged; also --frames
  --only features     what each feature adds to a small scene: characters, compile time, time of a sample; also --features
  --max-error N,…     what adaptive stops at (default: 0.05,0.02)
  --samples N         where adaptive gives up (default: 2048)
  --scene NAME        only this one of examples/scenes
  --engine NAME       ${ENGINES.join(', ')} (default: chromium)
  --quick             fewer turns, and of the settings only path and direct: under 3 minutes
  --json FILE         writes the numbers
  --from FILE         measures nothing, and takes the numbers that --json wrote; several of them are put together
  --report            writes docs/what-accuracy-costs.md and its plots, from the trade of all scenes
  --presets           tells which settings quality should stand for; fails if settings.ts says otherwise
  --help              this text

Without --only: scenes, trade, calibration and primitives; with --scene the first three, with --quick the first two.`;

export interface BenchOptions {
  readonly quick: boolean;
  readonly parts: readonly Part[];
  readonly scene: string | undefined;
  readonly engine: string;
  readonly maxErrors: readonly number[];
  readonly samples: number;
  readonly json: string | undefined;
  readonly from: readonly string[];
  readonly report: boolean;
  readonly presets: boolean;
  readonly help: boolean;
}

/** @throws {Error} in words for people. */
export function readOptions(args: readonly string[]): BenchOptions {
  const { values } = parseArgs({
    args: [...args],
    options: {
      quick: { type: 'boolean', default: false },
      only: { type: 'string' },
      scene: { type: 'string' },
      engine: { type: 'string', default: 'chromium' },
      json: { type: 'string' },
      from: { type: 'string', multiple: true, default: [] },
      report: { type: 'boolean', default: false },
      presets: { type: 'boolean', default: false },
      primitives: { type: 'boolean', default: false },
      convergence: { type: 'boolean', default: false },
      adaptive: { type: 'boolean', default: false },
      frames: { type: 'boolean', default: false },
      features: { type: 'boolean', default: false },
      'max-error': { type: 'string', default: '0.05,0.02' },
      samples: { type: 'string', default: '2048' },
      help: { type: 'boolean', default: false },
    },
  });
  const {
    only = (['primitives', 'convergence', 'adaptive', 'frames', 'features'] as const).find((part) => values[part]),
    quick,
    scene,
    engine,
    report,
    presets,
  } = values;
  if (only !== undefined) oneOf('only', only, PARTS);
  oneOf('engine', engine, ENGINES);
  const whole = !quick && scene === undefined && (only === undefined || only === 'trade');
  if ((report || presets) && !whole)
    throw new Error('--report and --presets need the trade of all scenes and settings');
  return {
    quick,
    parts: only === undefined ? PARTS.slice(0, quick ? 2 : scene === undefined ? 4 : 3) : [only as Part],
    scene,
    engine,
    maxErrors: values['max-error'].split(',').map(Number),
    samples: Number(values.samples),
    json: values.json,
    from: values.from,
    report,
    presets,
    help: values.help,
  };
}

export function oneOf(option: string, value: string, allowed: readonly string[]): string {
  if (!allowed.includes(value)) throw new Error(`--${option} takes ${allowed.join(', ')}, not ${value}`);
  return value;
}
