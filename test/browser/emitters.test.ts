// The light of lights, on the GPU and in the reference: from the same numbers the same direction, radiance and density.
import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import type { Vec3 } from '@ray-scene/core';
import { emitterFeatures } from '../../packages/core/src/emitter-record.ts';
import { emitterTable } from '../../packages/core/src/emitter-table.ts';
import type { EmittingScene, ImageEnvironment } from '../../packages/core/src/emitters.ts';
import type { Frame } from '../../packages/core/src/frame.ts';
import { rayInOwnSpace } from '../../packages/core/src/reference/light/emitter/own-space.ts';
import { emitterPdf, type Lighting, sampleEmitter } from '../../packages/core/src/reference/light/emitters.ts';
import { tracedShape } from '../../packages/core/src/reference/shape/index.ts';
import { addScaled, dot, length, normalize, subtract } from '../../packages/core/src/vector.ts';
import { RenderDevice } from '../../packages/ray-scene/src/render-device.ts';
import { EmitterProbe, type LightAnswer, type LightQuestion, roundedPoint } from '../truth/emitter-probe.ts';
import {
  emittingScene,
  inside,
  lightingOf,
  lights,
  numbers,
  outside,
  shapes,
  sky,
  surroundedBy,
} from '../unit/emitter-cases.ts';

const COUNT = 1500;
const frame: Frame = { origin: [0.3, -0.2, 0.7], scale: 1 / 4 };
const FAR = Math.fround(1e18);

type Place = { readonly p: Vec3; readonly own?: number };
type ProbeOptions = NonNullable<Parameters<EmitterProbe['answer']>[3]>;
type Sampled = ReturnType<typeof sampleEmitter>;

interface Asked {
  readonly question: LightQuestion;
  readonly sample: Sampled;
  readonly metPdf: number;
  /** Of an emitter in a space of its own the cosine there, which the shader finds; of others 1. */
  readonly ownCosine: number;
}

/** Questions from points, and what the reference says to the same numbers. */
function ask(lighting: Lighting, scene: EmittingScene, points: readonly Place[]): readonly Asked[] {
  const next = numbers(17);
  return Array.from({ length: COUNT }, (_, i) => {
    const { p, own } = points[i % points.length] as Place;
    const { inFrame, inScene } = roundedPoint(frame, p);
    const [which, u] = [next(), [next(), next()] as const];
    const sample = sampleEmitter(lighting, inScene, which, u, own);
    const emitter = lighting.emitters.findIndex((one) => 'object' in one && one.object === sample?.object);
    const direction = sample?.direction ?? [0, 0, 1];
    const t = sample?.distance ?? 1;
    const cosine = sample ? cosineAt(scene, inScene, sample) : 1;
    const met = Math.max(emitter, 0);
    return {
      question: {
        p: inFrame,
        which,
        u,
        own: own ?? -1,
        met: { emitter: met, direction, t: Math.min(t * frame.scale, FAR), cosine },
      },
      sample,
      metPdf: emitterPdf(lighting, met, inScene, direction, t, cosine, own),
      ownCosine: cosineInOwnSpace(scene, inScene, sample),
    };
  });
}

function cosineInOwnSpace({ objects }: EmittingScene, p: Vec3, sample: Sampled): number {
  const { place, ...shape } = objects[sample?.object ?? -1]?.shape ?? {};
  if (!place || !sample) return 1;
  const { from, d, t } = rayInOwnSpace(place, p, sample.direction, sample.distance);
  const own = shape as Parameters<typeof tracedShape>[0];
  return Math.abs(dot(tracedShape(own).normal(own, addScaled(from, d, t)), d));
}

function cosineAt({ objects }: EmittingScene, p: Vec3, { object, direction, distance }: NonNullable<Sampled>): number {
  const shape = object === undefined ? undefined : objects[object]?.shape;
  return shape ? dot(tracedShape(shape).normal(shape, addScaled(p, direction, distance)), direction) : 1;
}

/**
 * How far answers are from what is right: directions as angles (of what is nearer than 1, as ways across), radiances over the
 * largest, densities relative, distances relative or, below 1, as they are. On a surface seen edge on, distance and density
 * change by the change of direction over the cosine, which is no mistake. (Where a cosine is handed in, it is exact.)
 */
function differences(asked: readonly Asked[], answers: readonly LightAnswer[]) {
  const largest = { direction: 0, distance: 0, radiance: 0, pdf: 0, metPdf: 0 };
  const note = (name: keyof typeof largest, value: number): void => {
    largest[name] = Math.max(largest[name], value);
  };
  const peak = Math.max(...asked.map(({ sample }) => Math.max(...(sample?.radiance ?? [0]))));
  asked.forEach(({ question, sample, metPdf, ownCosine }, i) => {
    const answer = answers[i] as LightAnswer;
    const cosine = Math.abs(question.met.cosine);
    expect(answer.pdf > 0).to.equal(!!sample);
    if (!sample) return;
    expect([answer.delta, answer.object]).to.deep.equal([sample.delta, sample.object ?? -1]);
    const right = Math.min(sample.distance, FAR / frame.scale);
    note('direction', Math.min(right, 1) * length(subtract(answer.direction, sample.direction)));
    note('distance', (cosine * Math.abs(answer.distance / frame.scale - right)) / Math.max(right, 1));
    note('radiance', length(subtract(answer.radiance, sample.radiance)) / peak);
    note('pdf', cosine * relative(answer.pdf, sample.pdf));
    note('metPdf', ownCosine * relative(answer.metPdf, metPdf));
  });
  return largest;
}

const relative = (a: number, b: number): number => (a === b ? 0 : Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b)));

/** What f32 may leave. */
const limits = { direction: 1e-6, distance: 2e-6, radiance: 2e-6, pdf: 2e-6, metPdf: 2e-6 };

describe('lights on the GPU', function () {
  this.timeout(60_000);
  let device: RenderDevice;
  let probe: EmitterProbe;

  before(() => {
    device = new RenderDevice();
    probe = new EmitterProbe(device);
  });
  after(() => device.dispose());

  const check = (scene: EmittingScene, points: readonly Place[], options: ProbeOptions = {}): void => {
    const lighting = lightingOf(scene);
    const asked = ask(lighting, scene, points);
    const answers = probe.answer(
      lighting,
      frame,
      asked.map(({ question }) => question),
      options,
    );
    const found = differences(asked, answers);
    const broken = Object.entries(found).filter(([name, value]) => !(value <= limits[name as keyof typeof limits]));
    expect(broken).to.deep.equal([]);
  };

  const around = outside.map((p) => ({ p }));

  for (const [name, light] of Object.entries(lights)) {
    it(`are those of the reference: ${name}`, () => check(emittingScene([light], []), around));
  }

  for (const [name, shape] of Object.entries(shapes)) {
    const within = inside[name] ? [{ p: inside[name] as Vec3 }] : [];
    it(`are those of the reference: ${name}`, () => check(emittingScene([], [shape]), [...around, ...within]));
    it(`shine on one side only: ${name}`, () => {
      check(emittingScene([], [shape], 'front'), around);
      check(emittingScene([], [shape], 'back'), [...around, ...within]);
    });
  }

  it('are those of the reference: all kinds at once, and places for more', () => {
    const scene = emittingScene(Object.values(lights), Object.values(shapes));
    check(scene, around, { capacity: 32 });
    check(scene, around, { more: ['wideRange'] });
  });

  it('are chosen by the same numbers where there are few of a kind', () => {
    check(
      emittingScene([lights.point, { ...lights.point, intensity: 0.1 }, { ...lights.point, intensity: 0 }], []),
      around,
    );
  });

  it('are balls that aim as a spotlight does', () => {
    const ball = { type: 'sphere', center: lights.spot.position, radius: 0.3 };
    const scene = emittingScene([{ ...lights.spot, radius: 0.3 }], [ball, shapes.sphere]);
    check(
      { ...scene, objects: scene.objects.map((object, i) => (i === 0 ? { ...object, light: 0 } : object)) },
      around,
    );
  });

  it('are those of the reference: an image of the surroundings', () => {
    for (const [width, height] of [
      [64, 32],
      [100, 50],
      [1, 1],
    ] as const) {
      check(surroundedBy(sky(width, height), 2, 123), around);
      const scene = emittingScene(Object.values(lights), [shapes.disc]);
      check({ ...scene, environment: surroundedBy(sky(width, height)).environment as ImageEnvironment }, around);
    }
  });

  it('are those of the reference for a point on the light itself', () => {
    for (const [name, p] of Object.entries(inside)) {
      const shape = shapes[name as keyof typeof shapes];
      const direction = normalize([0.3, -0.5, 0.8]);
      const onIt = addScaled(p, direction, tracedShape(shape).distance(shape, { origin: p, direction }, false));
      check(emittingScene([], [shape]), [{ p: onIt, own: 0 }]);
    }
  });

  it('are those of the reference where they are very small', () => {
    const small = [
      { type: 'sphere', center: [1, 2, -1], radius: 1e-5 },
      { type: 'quad', corner: [1, 2, -1], edgeU: [1e-5, 0, 0], edgeV: [0, 0, 1e-5] },
      { type: 'disc', center: [1, 2, -1], normal: [0, 1, 0], radius: 1e-5 },
      { type: 'triangle', a: [1, 2, -1], b: [1.00001, 2, -1], c: [1, 2, -1.00001] },
      { type: 'box', center: [1, 2, -1], size: [1e-4, 1e-4, 1e-4] },
      { type: 'cylinder', base: [1, 2, -1], top: [1, 2.001, -1], radius: 1e-4 },
    ];
    for (const shape of small) check(emittingScene([], [shape]), around);
  });

  it('are numbers wherever they are asked for', () => {
    const scene = emittingScene(Object.values(lights), Object.values(shapes));
    const lighting = lightingOf(scene);
    const corners = [0, 0.5, 1 - 2 ** -24];
    const places = [
      ...Object.values(shapes).map(
        (shape) => Object.values(shape).find((value) => Array.isArray(value)) as unknown as Vec3,
      ),
      ...Object.values(inside),
      [0.5, 2, -1] as const,
      [1e12, 1e12, -1e12] as const,
    ];
    const questions = places.flatMap((p) =>
      corners.flatMap((which) =>
        corners.flatMap((a) =>
          corners.flatMap((b) =>
            [-1, 0, 3].map((own): LightQuestion => {
              const met = { emitter: Math.floor(which * 15), direction: [0, 0, 1] as const, t: a, cosine: b };
              return { p: roundedPoint(frame, p).inFrame, which, u: [a, b], own, met };
            }),
          ),
        ),
      ),
    );
    const unlit = { emitters: [], table: emitterTable([]) };
    for (const capacity of [1, 4]) {
      const present = emitterFeatures(lighting.emitters);
      for (const answer of probe.answer(unlit, frame, questions, { more: present, capacity })) {
        expect(allOf(answer).every(Number.isFinite)).to.equal(true);
        expect(answer.radiance).to.deep.equal([0, 0, 0]);
      }
    }
    for (const answer of probe.answer(lighting, frame, questions, {})) {
      expect(allOf(answer).every(Number.isFinite), JSON.stringify(answer)).to.equal(true);
    }
  });
});

const allOf = ({ direction, distance, radiance, pdf, metPdf, metRadiance }: LightAnswer): readonly number[] => [
  ...direction,
  distance,
  ...radiance,
  pdf,
  metPdf,
  ...metRadiance,
];
