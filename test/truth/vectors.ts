/** The vectors, asked of the reference, of the GPU, and of textbooks. */
import { expected, type Judged, judge, type Side, secondary, type Verdict } from './judge.ts';
import {
  type Answer,
  cameraProblem,
  type Problem,
  secondaryProblem,
  secondaryWatertightProblem,
  watertightProblem,
} from './problem.ts';
import { referenceAnswer } from './reference-side.ts';
import type { WatertightRow } from './rows.ts';
import { textbookDistance } from './textbook/shapes.ts';
import type { VectorCase, WatertightCase } from './vector-cases.ts';

/** All answers that a side gives to each problem. */
export type Ask = (problems: readonly Problem[]) => Promise<readonly (readonly Answer[])[]>;

export const judgeReference = (cases: readonly VectorCase[]): readonly Judged[] =>
  cases.map((one) => ({ one, verdict: judge(referenceAnswer(cameraProblem(one)), expected(one, 'reference')) }));

export const judgeTextbook = (cases: readonly VectorCase[]): readonly Judged[] =>
  cases.map((one) => {
    const answer = { t: textbookDistance(one), normal: [0, 0, 0] } as const;
    return { one, verdict: judge(answer, expected(one, 'gpu-camera')) };
  });

export async function judgeCamera(cases: readonly VectorCase[], ask: Ask): Promise<readonly Judged[]> {
  const answers = await ask(cases.map(cameraProblem));
  return cases.map((one, i) => ({ one, verdict: worst(answers[i] ?? [], expected(one, 'gpu-camera')) }));
}

export async function judgeSecondary(cases: readonly VectorCase[], ask: Ask): Promise<readonly Judged[]> {
  const moved = cases.map(secondary);
  const answers = await ask(moved.map((one) => secondaryProblem(one.moved)));
  return cases.map((one, i) => ({
    one,
    verdict: worst(answers[i] ?? [], (moved[i] as (typeof moved)[number]).expected),
  }));
}

/** Of several answers, the one that is furthest off counts, in each respect. */
function worst(answers: readonly Answer[], right: Parameters<typeof judge>[1]): Verdict {
  const verdicts = answers.map((answer) => judge(answer, right));
  const largest = (field: 'error' | 'raw' | 'normalError'): number | undefined => {
    const values = verdicts.map((verdict) => verdict[field]).filter((value) => value !== undefined);
    return values.length > 0 ? Math.max(...values) : undefined;
  };
  return {
    wrong: verdicts.length === 0 || verdicts.some(({ wrong }) => wrong),
    error: largest('error'),
    raw: largest('raw'),
    normalError: largest('normalError'),
  };
}

/** How many rays slip through between triangles that share an edge or a corner. */
export async function watertightRow(side: Side, cases: readonly WatertightCase[], ask: Ask): Promise<WatertightRow> {
  const problems = cases
    .filter(({ mustHit }) => mustHit)
    .map(side === 'gpu-secondary' ? secondaryWatertightProblem : watertightProblem);
  const answers = await ask(problems);
  // Elsewhere than on the camera's path the numbers are rounded to others: that these must hit, the reference says.
  const lost = problems.filter((problem, i) => {
    const missed = (answers[i] ?? []).some(({ t }) => !Number.isFinite(t));
    return missed && (side !== 'gpu-secondary' || Number.isFinite(referenceAnswer(problem).t));
  });
  return { side, cases: problems.length, lost: lost.length };
}

export const askReference: Ask = async (problems) => problems.map((problem) => [referenceAnswer(problem)]);
