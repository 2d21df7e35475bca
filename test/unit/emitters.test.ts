// What the reference says of lights: pdfs that are pdfs, samples that have them, and the light of shapes in closed form.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import type { Vec3 } from '@ray-scene/core';
import { coneDirection } from '../../packages/core/src/reference/light/emitter/cone.ts';
import { aroundDirection } from '../../packages/core/src/reference/light/emitter/inside.ts';
import { emitterPdf, type Lighting, sampleEmitter } from '../../packages/core/src/reference/light/emitters.ts';
import { tracedShape } from '../../packages/core/src/reference/shape/index.ts';
import { tangents } from '../../packages/core/src/reference/tangents.ts';
import { addScaled, dot, length, normalize } from '../../packages/core/src/vector.ts';
import { average, emittingScene, inside, lightingOf, numbers, outside, shapes } from './emitter-cases.ts';

type Name = keyof typeof shapes;
const names = Object.keys(shapes) as Name[];
const alone = Object.fromEntries(names.map((name) => [name, lightingOf(emittingScene([], [shapes[name]]))])) as {
  readonly [N in Name]: Lighting;
};

/** The points that a shape is looked at from: all around, in it, and on it. */
function views(name: Name): readonly { readonly p: Vec3; readonly own?: number }[] {
  const within = inside[name];
  const onIt = within ? [{ p: pointOn(name, within, [0.3, -0.5, 0.8]), own: 0 }] : [];
  return [...outside.map((p) => ({ p })), ...(within ? [{ p: within }] : []), ...onIt];
}

/** Where a shape is met from a point inside. */
function pointOn(name: Name, from: Vec3, along: Vec3): Vec3 {
  const direction = normalize(along);
  return addScaled(
    from,
    direction,
    tracedShape(shapes[name]).distance(shapes[name], { origin: from, direction }, false),
  );
}

/** The pdf of any direction: 0 where it does not meet the shape. */
function pdfAlong(name: Name, p: Vec3, direction: Vec3, own?: number): number {
  const shape = shapes[name];
  const t = tracedShape(shape).distance(shape, { origin: p, direction }, own === 0);
  if (!(t < Number.POSITIVE_INFINITY)) return 0;
  const cosine = dot(tracedShape(shape).normal(shape, addScaled(p, direction, t)), direction);
  return emitterPdf(alone[name], 0, p, direction, t, cosine, own);
}

/** What `pdfAlong` integrates to over the directions of each bin, found by chance, and the variance of that. */
function binned(name: Name, p: Vec3, own?: number): readonly { readonly mean: number; readonly variance: number }[] {
  const { axis, cone } = aim(name, p, own);
  const next = numbers(23);
  const sums = Array.from({ length: BINS * BINS }, () => ({ sum: 0, squares: 0 }));
  for (let i = 0; i < TRIES; i++) {
    const direction = coneDirection(axis, cone, [next(), next()]);
    const pdf = pdfAlong(name, p, direction, own) * 2 * Math.PI * cone;
    const bin = sums[binOf(axis, cone, direction)];
    if (!bin) continue;
    bin.sum += pdf;
    bin.squares += pdf * pdf;
  }
  return sums.map(({ sum, squares }) => ({ mean: sum / TRIES, variance: squares / TRIES ** 2 }));
}
const TRIES = 40_000;

/** A cone of directions that holds the shape. */
function aim(name: Name, p: Vec3, own?: number): { readonly axis: Vec3; readonly cone: number } {
  const lighting = alone[name];
  if (own !== undefined || p === inside[name]) return { axis: [0, 0, 1], cone: 2 };
  const next = numbers(5);
  const directions = Array.from({ length: 2000 }, () => sampleEmitter(lighting, p, 0, [next(), next()])?.direction);
  const axis = normalize(directions.reduce((sum: Vec3, d) => (d ? addScaled(sum, d, 1) : sum), [0, 0, 0]));
  const widest = Math.max(...directions.map((d) => (d ? 1 - dot(d, axis) : 0)));
  return { axis, cone: Math.min(1.1 * widest, 2) };
}

describe('emitters', () => {
  for (const name of names) {
    it(`have densities that integrate to 1: ${name}`, () => {
      for (const { p, own } of views(name)) {
        const bins = binned(name, p, own);
        const total = bins.reduce((sum, { mean }) => sum + mean, 0);
        const error = Math.sqrt(bins.reduce((sum, { variance }) => sum + variance, 0));
        // From a point on it, a part of the directions leads outside; of a sphere those are not asked.
        const expected = own === undefined || shapes[name].type === 'sphere' ? 1 : share(name, p);
        assert.ok(
          error < 0.05 && Math.abs(total - expected) < 4 * error,
          `${total} ± ${error}, not ${expected} from ${p}`,
        );
      }
    });

    it(`are sampled with those densities: ${name}`, () => {
      const lighting = alone[name];
      for (const { p, own } of views(name)) {
        const next = numbers(7);
        const n = 40_000;
        const { axis, cone } = aim(name, p, own);
        const counts = new Array<number>(BINS * BINS).fill(0);
        for (let i = 0; i < n; i++) {
          const sample = sampleEmitter(lighting, p, 0, [next(), next()], own);
          const bin = sample && sample.distance > 0 ? binOf(axis, cone, sample.direction) : -1;
          if (bin >= 0) counts[bin] = (counts[bin] as number) + 1;
        }
        const judged = binned(name, p, own)
          .map(({ mean, variance }, i) => ({ mean: n * mean, variance: n * n * variance, count: counts[i] as number }))
          .filter(({ mean }) => mean > 100);
        const chi2 = judged.reduce(
          (sum, { mean, variance, count }) => sum + (count - mean) ** 2 / (mean + variance),
          0,
        );
        assert.ok(judged.length > 3, `${judged.length} bins`);
        assert.ok(chi2 < judged.length + 5 * Math.sqrt(2 * judged.length), `χ² ${chi2} of ${judged.length} from ${p}`);
      }
    });

    it(`say of a sample what they say of its direction: ${name}`, () => {
      const lighting = alone[name];
      const shape = shapes[name];
      const next = numbers(3);
      for (const { p, own } of views(name)) {
        for (let i = 0; i < 200; i++) {
          const sample = sampleEmitter(lighting, p, 0, [next(), next()], own);
          if (!sample || sample.distance === 0) continue;
          const { direction, distance, pdf } = sample;
          assert.ok(Math.abs(length(direction) - 1) < 1e-12);
          const point = addScaled(p, direction, distance);
          const cosine = dot(tracedShape(shape).normal(shape, point), direction);
          const asked = emitterPdf(lighting, 0, p, direction, distance, cosine, own);
          assert.ok(Math.abs(asked / pdf - 1) < 1e-6, `${asked}, not ${pdf} from ${p}`);
          // Nothing of the shape itself is in front of the point.
          const t = tracedShape(shape).distance(shape, { origin: p, direction }, own === 0);
          if (t < Number.POSITIVE_INFINITY) assert.ok(Math.abs(t / distance - 1) < 1e-6, `${distance}, not ${t}`);
        }
      }
    });
  }
});

const BINS = 12;

/** Which of the bins of equal solid angle in a cone. */
function binOf(axis: Vec3, cone: number, direction: Vec3): number {
  const [x, y] = tangents(axis);
  const u = (1 - dot(axis, direction)) / cone;
  const v = Math.atan2(dot(direction, y), dot(direction, x)) / (2 * Math.PI);
  const [i, j] = [Math.floor(u * BINS), Math.floor((v < 0 ? v + 1 : v) * BINS)];
  return i >= 0 && i < BINS ? i * BINS + Math.min(j, BINS - 1) : -1;
}

/** The part of all directions in which a point on the surface sees that surface. */
function share(name: Name, p: Vec3): number {
  const next = numbers(29);
  let seen = 0;
  for (let i = 0; i < 100_000; i++) seen += pdfAlong(name, p, aroundDirection([next(), next()]), 0) > 0 ? 1e-5 : 0;
  return seen;
}

describe('the light of shapes', () => {
  const up: Vec3 = [0, 1, 0];
  const irradiance = (shape: object, p: Vec3, n: Vec3) =>
    average(
      lightingOf(emittingScene([], [shape])),
      p,
      ({ direction, radiance, pdf }) => (radiance[0] * Math.max(dot(direction, n), 0)) / pdf,
    );

  const close = ({ mean, error }: { mean: number; error: number }, expected: number): void =>
    assert.ok(Math.abs(mean - expected) <= 4 * error + 1e-9 * expected, `${mean} ± ${error}, not ${expected}`);

  it('is that of a sphere: π sin² cos', () => {
    for (const [r, d] of [
      [1, 3],
      [1, 1.01],
      [1e-9, 1e3],
      [1e9, 1e9 + 1],
    ] as const) {
      close(irradiance({ type: 'sphere', center: [0, d, 0], radius: r }, [0, 0, 0], up), Math.PI * (r / d) ** 2);
    }
  });

  it('is that of a disc across: π r² / (r² + h²)', () => {
    for (const [r, h] of [
      [1, 2],
      [3, 0.5],
      [1e-6, 1e3],
    ] as const) {
      const disc = { type: 'disc', center: [0, h, 0], normal: [0, -1, 0], radius: r };
      close(irradiance(disc, [0, 0, 0], up), (Math.PI * r * r) / (r * r + h * h));
    }
  });

  it('is that of a rectangle over its corner', () => {
    for (const [a, b, h] of [
      [1, 2, 1],
      [3, 3, 0.2],
      [0.01, 0.02, 1],
      [1e-5, 1e-5, 1e4],
    ] as const) {
      const quad = { type: 'quad', corner: [0, h, 0], edgeU: [a, 0, 0], edgeV: [0, 0, b] };
      const [x, y] = [a / h, b / h];
      const [p, q] = [Math.sqrt(1 + x * x), Math.sqrt(1 + y * y)];
      close(irradiance(quad, [0, 0, 0], up), ((x / p) * Math.atan(y / p) + (y / q) * Math.atan(x / q)) / 2);
    }
  });

  it('is that of all around from inside: π', () => {
    for (const name of ['sphere', 'box', 'cylinder'] as const) {
      const p = inside[name] as Vec3;
      close(irradiance(shapes[name], p, up), Math.PI);
      // From the surface itself, facing in: as much.
      const onIt = pointOn(name, p, [0.3, -0.5, 0.8]);
      const n = tracedShape(shapes[name]).normal(shapes[name], onIt);
      const lighting = alone[name];
      const facing = average(
        lighting,
        onIt,
        ({ direction, radiance, pdf }) => (radiance[0] * Math.max(-dot(direction, n), 0)) / pdf,
        { own: 0 },
      );
      close(facing, Math.PI);
    }
  });

  it('is what all directions bring that meet it, in a space of its own', () => {
    const p: Vec3 = [0.3, 0.1, -1];
    for (const name of names.filter((one) => 'place' in shapes[one])) {
      const shape = shapes[name];
      const next = numbers(37);
      const brought = Array.from({ length: 100_000 }, () => {
        const direction = aroundDirection([next(), next()]);
        const meets = tracedShape(shape).distance(shape, { origin: p, direction }, false) < Number.POSITIVE_INFINITY;
        return meets ? 4 * Math.PI * Math.max(direction[1], 0) : 0;
      });
      const mean = brought.reduce((sum, x) => sum + x, 0) / brought.length;
      const error = Math.sqrt(brought.reduce((sum, x) => sum + (x - mean) ** 2, 0)) / brought.length;
      const asked = irradiance(shape, p, up);
      assert.ok(
        Math.abs(asked.mean - mean) < 4 * Math.hypot(asked.error, error),
        `${name}: ${asked.mean}, not ${mean}`,
      );
      assert.ok(asked.error < error, `${asked.error} of 20,000 asked for, ${error} of 100,000 by chance`);
    }
  });

  it('is that of a box and a cylinder, whatever part of them is seen', () => {
    // Parts that shine by themselves are the same, added up.
    const box = { type: 'box', center: [0.5, 3, 0.5], size: [1, 2, 1] };
    const top = { type: 'quad', corner: [0, 2, 0], edgeU: [1, 0, 0], edgeV: [0, 0, 1] };
    const wall = { type: 'quad', corner: [1, 2, 0], edgeU: [0, 2, 0], edgeV: [0, 0, 1] };
    const p: Vec3 = [2, 0, 0.4];
    const parts = [top, wall].map((quad) => irradiance(quad, p, up));
    const sum = parts.reduce((total, { mean }) => total + mean, 0);
    const { mean, error } = irradiance(box, p, up);
    assert.ok(Math.abs(mean - sum) < 4 * (error + parts.reduce((total, part) => total + part.error, 0)));
    // A thin disc.
    const plate = { type: 'cylinder', base: [0, 2, 0], top: [0, 2.00001, 0], radius: 1 };
    close(irradiance(plate, [0, 0, 0], up), Math.PI / 5);
  });

  it('shines on the side that it is said to', () => {
    const quad = { type: 'quad', corner: [0, 1, 0], edgeU: [1, 0, 0], edgeV: [0, 0, 1] };
    const sums = (['front', 'back', 'both'] as const).map((side) => {
      const lighting = lightingOf(emittingScene([], [quad], side));
      return [
        [0.2, 0, 0.2],
        [0.2, 2, 0.2],
      ].map((p) => average(lighting, p as unknown as Vec3, ({ radiance }) => radiance[0]).mean);
    });
    // edgeU × edgeV points down.
    assert.deepEqual(sums, [
      [1, 0],
      [0, 1],
      [1, 1],
    ]);
  });
});
