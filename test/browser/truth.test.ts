// Intersections that were computed elsewhere, asked of the shaders that draw; `npm run truth` asks for all of them.
import { expect } from '@open-wc/testing';
import { addScaled } from '../../packages/core/src/vector.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { numbers } from '../bsdf/random.ts';
import { grazingRay, offTorus } from '../truth/grazing-torus.ts';
import { Probe } from '../truth/probe.ts';
import { isKind } from '../truth/reference-side.ts';
import { brokenLimits, vectorRows } from '../truth/rows.ts';
import { parseLines, type VectorCase, vectorKinds, type WatertightCase } from '../truth/vector-cases.ts';
import { type Ask, judgeCamera, judgeSecondary, watertightRow } from '../truth/vectors.ts';

/** Half an ulp of 1. */
const F32 = 2 ** -24;

declare const RAY_SCENE_FULL: boolean;

const lines = async <T>(file: string): Promise<readonly T[]> =>
  parseLines<T>(await (await fetch(`/test/truth/${file}.jsonl`)).text());

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
    cases = (await lines<VectorCase>('data/vectors/rays')).filter((_, i) => RAY_SCENE_FULL || i % 2 === 0);
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

  it('that were once off meet what they should', async () => {
    // See test/unit/truth.test.ts.
    const found = await lines<VectorCase>('found-rays');
    const rows = [
      ...vectorRows('gpu-camera', await judgeCamera(found, ask)),
      ...vectorRows('gpu-secondary', await judgeSecondary(found, ask)),
    ];
    expect(rows).to.not.be.empty;
    expect(brokenLimits(rows, [])).to.deep.equal([]);
  });

  // Cameras at the start of the ray, next to it, and away from it; each has its own formulas.
  for (const away of [0, 1e-6, 1e-3, 4]) {
    it(`that graze meet a torus where it is, or not at all, seen from ${away} of its radius away`, async () => {
      const random = numbers(1);
      const rays = Array.from({ length: 1000 }, () => grazingRay(random, F32));
      const answers = await ask(
        rays.map(({ shape, origin, direction }) => {
          const camera = addScaled(origin, [0.6, 0.64, 0.48], away * shape.radius);
          return { objects: [shape], camera, origin, direction, own: false };
        }),
      );
      const off = rays.map((ray, i) => Math.max(...(answers[i] ?? []).map(({ t }) => offTorus(ray, t, F32))));
      expect(Math.max(...off)).to.be.below(8);
      expect(off.filter((roundings) => roundings > 0)).to.have.length.above(300);
    });
  }

  if (isKind('triangle')) {
    it('do not slip through between triangles', async () => {
      const triangles = await lines<WatertightCase>('data/vectors/watertight');
      const rows = [
        await watertightRow('gpu-camera', triangles, ask),
        await watertightRow('gpu-secondary', triangles, ask),
      ];
      expect(brokenLimits([], rows)).to.deep.equal([]);
    });
  }
});
