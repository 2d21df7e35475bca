// What light does at the surfaces of the shaders, without looking at their f64 twins.
import { expect } from '@open-wc/testing';
import type { Vec3 } from '@ray-scene/core';
import type { Bsdf } from '../../packages/core/src/reference/material/bsdf.ts';
import { length } from '../../packages/core/src/vector.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { bsdfOf, definedFor, materials } from '../bsdf/cases.ts';
import { directionTo, type Furnace, histogramError, midpoints, wideMaterials } from '../bsdf/physics.ts';
import { askBsdf, probeSource } from '../bsdf/probe.ts';
import type { Question } from '../bsdf/questions.ts';
import { numbers } from '../bsdf/random.ts';

describe('light at surfaces on the GPU', function () {
  this.timeout(120_000);
  let device: RenderDevice;
  let program: Program;
  before(() => {
    device = new RenderDevice();
    program = new Program(device.gl, probeSource(definedFor(Object.values(materials))));
  });
  after(() => device.dispose());

  const samples = (bsdf: Bsdf, questions: readonly Question[]) =>
    askBsdf(device.gl, program, bsdf, questions).map(({ sample }) => sample);

  for (const [name, bsdf] of wideMaterials) {
    it(`goes from ${name} as often into a direction as its density says`, () => {
      const wo = directionTo(0.4);
      expect(histogramError(bsdf, wo, samples(bsdf, randomQuestions(wo, 20000)))).to.be.below(4);
    });
  }

  it('comes back from a white metal as single scattering leaves it', async () => {
    const { alpha, cosTheta, E_sep }: Furnace = await (await fetch('/test/truth/data/brdf/furnace.json')).json();
    for (const [i, width] of alpha.entries()) {
      const metal = bsdfOf({ metalness: 1, alpha: width });
      for (const [k, z] of cosTheta.entries()) {
        // Every other one.
        if ((i + k) % 2) continue;
        const found = samples(
          metal,
          midpoints.map(({ u }) => ({ wo: directionTo(z), u, lobe: 0.5, wi: directionTo(1) })),
        ).reduce((sum, { weight }, n) => sum + weight[0] * (midpoints[n]?.weight ?? 0), 0);
        expect(found).to.be.closeTo(E_sep[i]?.[k] as number, 2e-4);
      }
    }
  });

  it('is never more than what arrived, at metal and glass of any roughness and from any direction', () => {
    for (const alpha of [0, 2 ** -32, 1e-4, 0.01, 0.3, 1]) {
      for (const looks of [{ metalness: 1 }, {}, { inside: true }, { thin: true }, { ior: 1 }]) {
        const bsdf = bsdfOf({ alpha, transmission: 1, ...looks });
        for (const z of [1, 0.3, 1e-4, 0]) {
          for (const { wi, weight } of samples(bsdf, randomQuestions(directionTo(z), 256))) {
            // Radiance grows with the square of the index, power does not.
            const scaling = wi[2] < 0 && !bsdf.thin ? bsdf.eta ** 2 : 1;
            expect(weight[0] * scaling).to.be.at.most(1 + 1e-6);
            expect(length(wi)).to.be.closeTo(1, 1e-6);
          }
        }
      }
    }
  });
});

function randomQuestions(wo: Vec3, count: number): readonly Question[] {
  const random = numbers(11);
  return Array.from({ length: count }, () => ({ wo, u: [random(), random()], lobe: random(), wi: directionTo(1) }));
}
