// The BSDFs of the shaders against their f64 twins, direction by direction, on the same random numbers.
import { expect } from '@open-wc/testing';
import type { Vec3 } from '@ray-scene/core';
import { type Bsdf, bsdfSample, bsdfValue, isMirrorOnly } from '../../packages/core/src/reference/material/bsdf.ts';
import { length, subtract } from '../../packages/core/src/vector.ts';
import { Program } from '../../packages/ray-scene/src/program.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { definedFor, materials } from '../bsdf/cases.ts';
import { type Answer, askBsdf, probeSource } from '../bsdf/probe.ts';
import { anyMaterial, anyQuestion, direction, NEARLY_1, type Question, rounded } from '../bsdf/questions.ts';
import { numbers } from '../bsdf/random.ts';

/** So many questions; the first ones are about extremes, of which it is only asked that they have answers. */
const COUNT = 5120;
const EXTREMES = 1024;

const quantile = (values: readonly number[], share: number): number =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))] ?? 0;

describe('BSDFs on the GPU', function () {
  this.timeout(120_000);
  let device: RenderDevice;
  const programs = new Map<string, Program>();
  before(() => {
    device = new RenderDevice();
  });
  after(() => device.dispose());

  const programFor = (defined: ReadonlySet<string>): Program => {
    const key = [...defined].join();
    const program = programs.get(key) ?? new Program(device.gl, probeSource(defined));
    programs.set(key, program);
    return program;
  };

  const all = definedFor(Object.values(materials));

  it('answers with numbers, whatever the material and the directions', () => {
    const random = numbers(13);
    for (let i = 0; i < 300; i++) {
      const bsdf = anyMaterial(random);
      const questions = Array.from({ length: 256 }, () => anyQuestion(random));
      const at = askBsdf(device.gl, programFor(all), bsdf, questions).findIndex((answer) => !isNumbers(answer));
      expect(at < 0 ? '' : JSON.stringify([bsdf, questions[at]])).to.equal('');
    }
  });

  it('are a shader for scenes without any material too', () => {
    programFor(definedFor([])).use();
  });

  for (const [name, bsdf] of Object.entries(materials)) {
    it(`scatters ${name} as in f64, by a shader of its own and by one for all`, () => {
      const questions = questionsOf(bsdf);
      for (const defined of [definedFor([bsdf]), all]) {
        const answers = askBsdf(device.gl, programFor(defined), bsdf, questions);
        expect(answers.filter((answer) => !isNumbers(answer)).length, 'answers with Infinity or NaN').to.equal(0);
        expect((answers[0] as Answer).isMirrorOnly).to.equal(isMirrorOnly(bsdf));
        judge(errorsOf(bsdf, questions.slice(EXTREMES), answers.slice(EXTREMES)));
      }
    });
  }
});

function judge(errors: ReturnType<typeof errorsOf>): void {
  for (const [what, of] of Object.entries(errors)) {
    expect(quantile(of, 0.5), `${what}, median`).to.be.below(4e-7);
    // At edges (of total reflection, of what is seen at all) digits are lost, and one rounding decides between lobes.
    expect(quantile(of, 0.99), `${what}, 99 %`).to.be.below(1e-4);
  }
  const turned = errors.wi.filter((off) => !(off < 1e-3)).length;
  expect(turned / errors.wi.length, 'share of directions that are others').to.be.below(2e-3);
}

const isNumbers = ({ sample, value }: Answer): boolean =>
  [...sample.wi, ...sample.weight, sample.pdf, ...value.value, value.pdf].every(Number.isFinite);

/** How far off each answer is: directions by their distance, all else relative to the right value. */
function errorsOf(bsdf: Bsdf, questions: readonly Question[], answers: readonly Answer[]) {
  const right = questions.map(({ wo, u, lobe, wi }) => ({
    sample: bsdfSample(bsdf, wo, u, lobe),
    value: bsdfValue(bsdf, wo, wi),
  }));
  const errors = (of: (found: Pick<Answer, 'sample' | 'value'>, right: Pick<Answer, 'sample' | 'value'>) => number) =>
    answers.map((answer, i) => of(answer, right[i] as Pick<Answer, 'sample' | 'value'>));
  return {
    wi: errors((a, b) => length(subtract(a.sample.wi, b.sample.wi))),
    weight: errors((a, b) => relative(a.sample.weight, b.sample.weight)),
    pdf: errors((a, b) => relative([a.sample.pdf], [b.sample.pdf])),
    value: errors((a, b) => relative(a.value.value, b.value.value)),
    'pdf of a direction': errors((a, b) => relative([a.value.pdf], [b.value.pdf])),
  };
}

function relative(values: readonly number[], right: readonly number[]): number {
  const size = Math.max(...right.map(Math.abs));
  const off = Math.max(...values.map((value, i) => Math.abs(value - (right[i] as number))));
  return off === 0 ? 0 : off / size;
}

function questionsOf(bsdf: Bsdf): readonly Question[] {
  const random = numbers(7);
  const extremes = [0, 2 ** -24, 0.5, NEARLY_1];
  return Array.from({ length: COUNT }, (_, i): Question => {
    const isExtreme = i < EXTREMES;
    const number = (step: number): number =>
      isExtreme ? (extremes[Math.floor(i / step) % extremes.length] as number) : random();
    const wo = isExtreme ? (EDGES[Math.floor(i / 256)] as Vec3) : direction(random, i % 8 === 0);
    const drawn = bsdfSample(bsdf, wo, [number(4), number(16)], random()).wi;
    const any = direction(random, false).map((x, k) => (k === 2 && i % 4 ? -x : x)) as unknown as Vec3;
    return { wo, u: [number(4), number(16)], lobe: number(1), wi: i % 2 ? rounded(drawn) : any };
  });
}

/** Straight on, a rounding off it, nearly grazing, and grazing. */
const EDGES: readonly Vec3[] = [
  [0, 0, 1],
  [2 ** -13, 2 ** -20, 1],
  [Math.fround(0.6), Math.fround(0.8), 2 ** -30],
  [1, 0, 0],
];
