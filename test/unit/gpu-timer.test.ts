/** What timer queries tell: a time in milliseconds, or that nobody knows. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gpuTimer } from '../../packages/ray-scene/src/gpu-timer.ts';

interface Answers {
  readonly available: boolean;
  readonly disjoint: boolean;
  readonly nanoseconds: number;
}

const EXTENSION = { TIME_ELAPSED_EXT: 1, GPU_DISJOINT_EXT: 2 };

/** A context whose queries all have these answers. */
function contextWith(answers: Answers, extension: typeof EXTENSION | null = EXTENSION) {
  const queries = new Set<object>();
  const calls: string[] = [];
  const gl = {
    QUERY_RESULT_AVAILABLE: 3,
    QUERY_RESULT: 4,
    getExtension: (name: string) => (name === 'EXT_disjoint_timer_query_webgl2' ? extension : null),
    createQuery() {
      const query = {};
      queries.add(query);
      return query;
    },
    beginQuery: (target: number, query: object) => calls.push(`begin ${target} ${queries.has(query)}`),
    endQuery: (target: number) => calls.push(`end ${target}`),
    deleteQuery: (query: object) => queries.delete(query),
    getParameter: (name: number) => name === EXTENSION.GPU_DISJOINT_EXT && answers.disjoint,
    getQueryParameter(query: object, name: number) {
      assert.ok(queries.has(query), 'a query that was deleted is asked');
      return name === 3 ? answers.available : answers.nanoseconds;
    },
  };
  return { gl: gl as unknown as WebGL2RenderingContext, queries, calls };
}

function timeOf(answers: Answers): { readonly time: number | undefined; readonly left: number } {
  const { gl, queries } = contextWith(answers);
  const timer = gpuTimer(gl);
  timer?.begin();
  const time = timer?.end()();
  return { time, left: queries.size };
}

const KNOWN: Answers = { available: true, disjoint: false, nanoseconds: 2_500_000 };

test('where pages are told no times there is no timer', () => {
  assert.equal(gpuTimer(contextWith(KNOWN, null).gl), undefined);
});

test('a query is about what is drawn between its begin and its end, and tells milliseconds', () => {
  const { gl, calls } = contextWith(KNOWN);
  const timer = gpuTimer(gl);
  timer?.begin();
  const read = timer?.end();
  assert.deepEqual(calls, ['begin 1 true', 'end 1']);
  assert.equal(read?.(), 2.5);
});

test('a time is unknown that is not there yet, that the GPU disowns, or that is none', () => {
  for (const change of [{ available: false }, { disjoint: true }, { nanoseconds: 0 }]) {
    assert.deepEqual(timeOf({ ...KNOWN, ...change }), { time: undefined, left: 0 });
  }
});

test('queries are given back once they are read, and each batch has its own', () => {
  const { gl, queries } = contextWith(KNOWN);
  const timer = gpuTimer(gl);
  timer?.begin();
  const first = timer?.end();
  timer?.begin();
  const second = timer?.end();
  assert.equal(queries.size, 2);
  first?.();
  second?.();
  assert.equal(queries.size, 0);
});
