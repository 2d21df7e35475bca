// Intersections that were computed elsewhere, asked of the shaders that draw; `npm run truth` asks for all of them.
import { expect } from '@open-wc/testing';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { Probe } from '../truth/probe.ts';
import { isKind } from '../truth/reference-side.ts';
import { brokenLimits, vectorRows } from '../truth/rows.ts';
import { parseLines, type VectorCase, vectorKinds, type WatertightCase } from '../truth/vector-cases.ts';
import { type Ask, judgeCamera, judgeSecondary, watertightRow } from '../truth/vectors.ts';

declare const RAY_SCENE_FULL: boolean;

const lines = async <T>(file: string): Promise<readonly T[]> =>
  parseLines<T>(await (await fetch(`/test/truth/data/vectors/${file}.jsonl`)).text());

describe('rays on the GPU', function () {
  this.timeout(120_000);

  let device: RenderDevice;
  let ask: Ask;
  let cases: readonly VectorCase[];

  before(async () => {
    device = new RenderDevice();
    const probe = new Probe(device);
    ask = async (problems) => probe.answer(problems);
    // Every other one, which is some of every kind and regime.
    cases = (await lines<VectorCase>('rays')).filter((_, i) => RAY_SCENE_FULL || i % 2 === 0);
  });
  after(() => device.dispose());

  for (const kind of vectorKinds.filter(isKind)) {
    it(`meet a ${kind} where they should`, async () => {
      const ofKind = cases.filter(({ prim }) => prim === kind);
      const rows = [
        ...vectorRows('gpu-camera', await judgeCamera(ofKind, ask)),
        ...vectorRows('gpu-secondary', await judgeSecondary(ofKind, ask)),
      ];
      expect(rows).to.not.be.empty;
      expect(brokenLimits(rows, [])).to.deep.equal([]);
    });
  }

  if (isKind('triangle')) {
    it('do not slip through between triangles', async () => {
      const triangles = await lines<WatertightCase>('watertight');
      const rows = [
        await watertightRow('gpu-camera', triangles, ask),
        await watertightRow('gpu-secondary', triangles, ask),
      ];
      expect(brokenLimits([], rows)).to.deep.equal([]);
    });
  }
});
