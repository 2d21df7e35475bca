/** `npm run truth`: how right the reference and the GPU are, by numbers that this project did not make. See HELP. */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ENGINES } from '../browsers.mjs';
import { reportCounts } from '../counts.mjs';
import { type BrdfCase, brdfError, brdfTables, skippedTables } from './brdf-tables.ts';
import { bsdfTables } from './bsdf-tables.ts';
import { writeDoc } from './doc.ts';
import { Gpu } from './gpu-side.ts';
import { type ImageRow, MAX_ERROR_RATIO } from './images/judge-image.ts';
import { measureImages } from './images/measure-images.ts';
import { isKind } from './reference-side.ts';
import { imageLine, printReport, type Truth } from './report.ts';
import { type BrdfRow, brokenLimits, quantile, type VectorRow, vectorRows, type WatertightRow } from './rows.ts';
import { parseLines, type VectorCase, vectorKinds, type WatertightCase } from './vector-cases.ts';
import { askReference, judgeCamera, judgeReference, judgeSecondary, judgeTextbook, watertightRow } from './vectors.ts';

const HELP = `npm run truth -- [options]

Measures the f64 reference and the GPU path against ground truth that this project did not compute.

  --data DIR      the truth (default: test/truth/data)
  --engine NAME   cpu (the reference alone), or the GPU path alone in chromium, firefox or webkit
                  (default: cpu and chromium). On software renderers, programs read a scene in two ways;
                  the worse answer counts.
  --only PART     vectors, brdf or images
  --scene NAME    of the images, this one
  --samples N     of the images: per pixel, at most (default: 65536)
  --errors N      of the images: their mean standard error, at most so many times that of the truth (default: 3).
                  As many samples are taken as that needs, by the error of the first 128
  --pictures DIR  of the images, writes PNG files there: ours, theirs, and the difference in standard errors
  --json FILE     writes all numbers there, of the images at each one
  --resume        of the images, keeps what FILE has and is good, and measures what it has not
  --doc FILE      writes the tables of vectors and images there: docs/how-exact.md has places for them

Ends with 1 when a limit is broken.`;

const PARTS = ['vectors', 'brdf', 'images'];

const { values: options } = parseArgs({
  options: {
    data: { type: 'string', default: 'test/truth/data' },
    engine: { type: 'string' },
    only: { type: 'string' },
    scene: { type: 'string' },
    samples: { type: 'string', default: '65536' },
    errors: { type: 'string', default: `${MAX_ERROR_RATIO}` },
    pictures: { type: 'string' },
    json: { type: 'string' },
    resume: { type: 'boolean', default: false },
    doc: { type: 'string' },
    help: { type: 'boolean', default: false },
  },
});

function check(option: string, value: string | undefined, allowed: readonly string[]): void {
  if (value !== undefined && !allowed.includes(value)) {
    throw new Error(`--${option} takes ${allowed.join(', ')}, not ${value}`);
  }
}

const lines = <T>(...path: string[]): readonly T[] => parseLines(readFileSync(join(options.data, ...path), 'utf8'));

const wants = (part: string): boolean => (options.only ?? part) === part && (part === 'images' || !options.scene);

const images = (
  onCpu: boolean,
  gpu: Gpu | undefined,
  onRow: (row: ImageRow, rows: readonly ImageRow[]) => void,
): Promise<readonly ImageRow[]> =>
  measureImages({
    data: join(options.data, 'images'),
    scene: options.scene,
    known: knownImages(),
    onCpu,
    gpu,
    mostSamples: Number(options.samples),
    mostErrors: Number(options.errors),
    pictures: options.pictures,
    onProgress: (what) => console.error(what),
    onRow,
  });

/** What an earlier run has written, unless it broke a limit. */
function knownImages(): readonly ImageRow[] {
  if (!options.resume || !options.json || !existsSync(options.json)) return [];
  const { images: rows } = JSON.parse(readFileSync(options.json, 'utf8')) as Truth;
  return rows.filter(({ broken }) => broken.length === 0);
}

interface VectorResult {
  readonly rows: readonly VectorRow[];
  readonly textbook: readonly VectorRow[];
  readonly watertight: readonly WatertightRow[];
  readonly skipped: readonly string[];
}

async function measureVectors(onCpu: boolean, gpu: Gpu | undefined): Promise<VectorResult> {
  const all = lines<VectorCase>('vectors', 'rays.jsonl');
  const cases = all.filter(({ prim }) => isKind(prim));
  const rows: VectorRow[] = [];
  const watertight: WatertightRow[] = [];
  const triangles = isKind('triangle') ? lines<WatertightCase>('vectors', 'watertight.jsonl') : [];
  if (onCpu) {
    rows.push(...vectorRows('reference', judgeReference(cases)));
    if (triangles.length > 0) watertight.push(await watertightRow('reference', triangles, askReference));
  }
  if (gpu) {
    rows.push(...vectorRows('gpu-camera', await judgeCamera(cases, gpu.ask)));
    rows.push(...vectorRows('gpu-secondary', await judgeSecondary(cases, gpu.ask)));
    for (const side of triangles.length > 0 ? (['gpu-camera', 'gpu-secondary'] as const) : []) {
      watertight.push(await watertightRow(side, triangles, gpu.ask));
    }
  }
  const missing = vectorKinds.filter((kind) => !isKind(kind));
  const skipped = [...missing, ...(triangles.length > 0 ? [] : ['watertight'])].map((what) => `vectors of ${what}`);
  return { rows, textbook: vectorRows('textbook', judgeTextbook(cases)), watertight, skipped };
}

async function measureBrdf(onCpu: boolean, gpu: Gpu | undefined): Promise<readonly BrdfRow[]> {
  const rows: BrdfRow[] = [];
  const measureTable = async <Q>(table: string, cases: readonly BrdfCase<Q>[], ask?: AskBrdf<Q>): Promise<void> => {
    const references = (): readonly (readonly number[])[] => cases.map(({ reference }) => reference());
    if (onCpu) rows.push(brdfRow('reference', table, cases, references()));
    if (ask) rows.push(brdfRow('gpu', table, cases, await ask(cases.map(({ question }) => question))));
  };
  for (const [table, caseOf] of Object.entries(brdfTables)) {
    await measureTable(table, lines<never>('brdf', `${table}.jsonl`).map(caseOf), gpu?.reflectance);
  }
  for (const [table, { file, casesOf }] of Object.entries(bsdfTables)) {
    await measureTable(table, casesOf(lines<never>('brdf', `${file}.jsonl`)), gpu?.scattering);
  }
  return rows;
}

type AskBrdf<Q> = (questions: readonly Q[]) => Promise<readonly (readonly number[])[]>;

function brdfRow(
  side: BrdfRow['side'],
  table: string,
  cases: readonly BrdfCase<unknown>[],
  values: readonly (readonly number[])[],
): BrdfRow {
  const errors = cases.map((one, i) => brdfError(values[i] ?? [], one, side));
  return { side, table, cases: cases.length, p99: quantile(errors, 0.99), max: quantile(errors, 1) };
}

const brokenByImage = ({ side, scene, broken }: ImageRow): readonly string[] =>
  broken.map((what) => `${side} ${scene}: ${what}`);

async function measure(): Promise<Truth> {
  const { engine } = options;
  const onCpu = engine === undefined || engine === 'cpu';
  const gpu = engine === 'cpu' ? undefined : await Gpu.start(engine ?? 'chromium');
  try {
    const vectors = wants('vectors') ? await measureVectors(onCpu, gpu) : undefined;
    const brdf = wants('brdf') ? await measureBrdf(onCpu, gpu) : [];
    // Pictures take long: what is interrupted has written those that were ready.
    const onRow = (row: ImageRow, rows: readonly ImageRow[]): void => {
      console.error(imageLine(row));
      save(truthOf(vectors, brdf, rows));
    };
    return truthOf(vectors, brdf, wants('images') ? await images(onCpu, gpu, onRow) : []);
  } finally {
    await gpu?.close();
  }
}

function truthOf(vectors: VectorResult | undefined, brdf: readonly BrdfRow[], pictures: readonly ImageRow[]): Truth {
  const { rows = [], textbook = [], watertight = [] } = vectors ?? {};
  const noTables = wants('brdf') ? skippedTables.map((table) => `brdf ${table}`) : [];
  return {
    vectors: rows,
    watertight,
    brdf,
    images: pictures,
    textbook,
    skipped: [...(vectors?.skipped ?? []), ...noTables],
    broken: [...brokenLimits(rows, watertight), ...pictures.flatMap(brokenByImage)],
  };
}

function save(truth: Truth): void {
  if (options.json) writeFileSync(options.json, `${JSON.stringify(truth, null, 2)}\n`);
}

if (options.help) {
  console.log(HELP);
} else {
  check('engine', options.engine, ['cpu', ...ENGINES]);
  check('only', options.only, PARTS);
  const truth = await measure();
  printReport(truth);
  if (options.doc) writeDoc(options.doc, truth);
  save(truth);
  const failed = truth.images.filter(({ broken }) => broken.length > 0).length;
  const skipped = truth.images.filter((row) => row.skipped !== null && row.broken.length === 0).length;
  reportCounts('truth images', { passed: truth.images.length - failed - skipped, failed, skipped });
  if (truth.broken.length > 0) process.exitCode = 1;
}
