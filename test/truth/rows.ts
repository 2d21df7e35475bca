/** Verdicts gathered into the rows of the report, and the limits that they are held to. */
import type { Judged, Side } from './judge.ts';
import type { VectorKind } from './vector-cases.ts';

export interface VectorRow {
  readonly side: string;
  readonly primitive: VectorKind;
  readonly regime: string;
  readonly cases: number;
  readonly wrong: number;
  /** Those whose t is judged: both the truth and the answer are hits. */
  readonly hits: number;
  /** Errors of t in units of the conditioning. */
  readonly p50: number;
  readonly p90: number;
  readonly p99: number;
  readonly max: number;
  /** Plain relative error of t. */
  readonly rawP99: number;
  /** Errors of the normal in units of its conditioning. */
  readonly normalP99: number;
  readonly normalMax: number;
  /** The names of the cases that are wrong. */
  readonly wrongCases: readonly string[];
  /** The case with the largest error. */
  readonly worst?: string;
}

export interface WatertightRow {
  readonly side: Side;
  readonly cases: number;
  readonly lost: number;
}

export interface BrdfRow {
  readonly side: 'reference' | 'gpu';
  readonly table: string;
  readonly cases: number;
  readonly p99: number;
  readonly max: number;
}

/** One row for each primitive and regime, in the order in which they come. */
export function vectorRows(side: string, judged: readonly Judged[]): readonly VectorRow[] {
  const groups = new Map<string, Judged[]>();
  for (const entry of judged) {
    const key = `${entry.one.prim}/${entry.one.regime}`;
    groups.set(key, [...(groups.get(key) ?? []), entry]);
  }
  return [...groups.values()].map((group) => vectorRow(side, group));
}

function vectorRow(side: string, group: readonly Judged[]): VectorRow {
  const { prim, regime } = (group[0] as Judged).one;
  const numbers = (field: 'error' | 'raw' | 'normalError'): readonly number[] =>
    group.map(({ verdict }) => verdict[field]).filter((value) => value !== undefined);
  const errors = numbers('error');
  const normals = numbers('normalError');
  const wrongCases = group.filter(({ verdict }) => verdict.wrong).map(({ one }) => one.id);
  const max = quantile(errors, 1);
  const worst = group.find(({ verdict }) => verdict.error === max)?.one.id;
  return {
    side,
    primitive: prim,
    regime,
    cases: group.length,
    wrong: wrongCases.length,
    hits: errors.length,
    p50: quantile(errors, 0.5),
    p90: quantile(errors, 0.9),
    p99: quantile(errors, 0.99),
    max,
    rawP99: quantile(numbers('raw'), 0.99),
    normalP99: quantile(normals, 0.99),
    normalMax: quantile(normals, 1),
    wrongCases,
    ...(worst ? { worst } : {}),
  };
}

/** Between the two nearest values, linearly; 0 of none. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  const place = share * (sorted.length - 1);
  const low = sorted[Math.floor(place)] ?? 0;
  const high = sorted[Math.ceil(place)] ?? 0;
  return high === low ? low : low + (place - Math.floor(place)) * (high - low);
}

interface Limits {
  readonly p99: number;
  readonly max: number;
}

export function limitsOf({ side, primitive }: Pick<VectorRow, 'side' | 'primitive'>): Limits {
  if (primitive === 'torus') return { p99: 16, max: 256 };
  return side === 'gpu-secondary' ? { p99: 16, max: 128 } : { p99: 8, max: 64 };
}

/** Of plain errors in `huge` on the camera path. */
const HUGE_RAW_P99 = 1e-5;

/** One sentence for each limit that a row does not keep. */
export function brokenLimits(rows: readonly VectorRow[], watertight: readonly WatertightRow[]): readonly string[] {
  return [
    ...rows.flatMap(brokenByRow),
    ...watertight.filter(({ lost }) => lost > 0).map(({ side, lost }) => `${side} watertight: ${lost} lost`),
  ];
}

function brokenByRow(row: VectorRow): readonly string[] {
  const { side, primitive, regime, wrong, p99, max, rawP99, wrongCases, worst } = row;
  const limits = limitsOf(row);
  const wrongAllowed = regime === 'edge' ? 1 : 0;
  const broken = [
    wrong > wrongAllowed && `${wrong} wrong, at most ${wrongAllowed}: ${wrongCases.join(' ')}`,
    !(p99 <= limits.p99) && `p99 ${p99.toPrecision(3)}, at most ${limits.p99}`,
    !(max <= limits.max) && `max ${max.toPrecision(3)}, at most ${limits.max} (${worst})`,
    side === 'gpu-camera' &&
      regime === 'huge' &&
      !(rawP99 < HUGE_RAW_P99) &&
      `rawP99 ${rawP99.toExponential(1)}, below ${HUGE_RAW_P99}`,
  ];
  return broken.filter((what) => what !== false).map((what) => `${side} ${primitive}/${regime}: ${what}`);
}
