// When `complete` is told: once each time a picture that was not complete has become so.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parseScene } from '@ray-scene/core';
import type { Progress } from '../../packages/ray-scene/src/picture.ts';
import { ProgressReport } from '../../packages/ray-scene/src/progress-report.ts';

const scene = parseScene({ objects: [{ type: 'sphere' }] });
const DONE: Progress = { samples: 4, added: true, shown: true, more: false, stopped: 'samples', error: undefined };

function report() {
  const host = new EventTarget();
  const told: string[] = [];
  for (const type of ['progress', 'complete']) host.addEventListener(type, () => told.push(type));
  const progress = new ProgressReport(host);
  return { told, tell: (one: Partial<Progress>) => progress.tell({ ...DONE, ...one }, 4, scene) };
}

describe('a report of progress', () => {
  it('tells once that a picture is complete', () => {
    const { told, tell } = report();
    tell({});
    tell({ added: false });
    assert.deepEqual(told, ['progress', 'complete']);
  });

  it('tells that a picture is complete which got less than a sample of each pixel before its time was up', () => {
    const { told, tell } = report();
    tell({});
    tell({ added: false, more: true, stopped: undefined });
    tell({ added: false, stopped: 'time' });
    assert.deepEqual(told, ['progress', 'complete', 'complete']);
  });
});
