import assert from 'node:assert/strict';
import { test } from 'node:test';
import '@ray-scene/core/parts';
import {
  generateShader,
  packScene,
  parseScene,
  requirements,
  resolveScene,
  type SceneError,
  type Vec3,
} from '@ray-scene/core';
import fc from 'fast-check';
import { planeAxes } from '../../packages/core/src/primitives/plane.ts';
import { torus } from '../../packages/core/src/primitives/torus-shape.ts';
import { torusDistance, torusLengths, torusNormal } from '../../packages/core/src/reference/shape/torus.ts';
import { add, addScaled, dot, length, negate, normalize, scale, subtract } from '../../packages/core/src/vector.ts';
import { numbers } from '../bsdf/random.ts';
import { grazingRay, offTorus } from '../truth/grazing-torus.ts';

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const triple = fc.tuple(real(-3, 3), real(-3, 3), real(-3, 3));
const direction = triple.filter((v) => Math.hypot(...v) > 0.1).map((v) => normalize(v));
const angle = real(-Math.PI, Math.PI);
const ring = fc
  .record({ center: triple, axis: direction, radius: real(0.2, 3), share: real(0.02, 0.95) })
  .map(({ share, ...shape }) => ({ type: 'torus' as const, ...shape, tube: share * shape.radius }));

type Ring = Parameters<typeof torusDistance>[0];

/** The point at angles around the axis, from the tangent, and around the tube, from its outer circle; and its normal. */
function place({ center, axis, radius, tube }: Ring, around: number, tubeAngle: number) {
  const { normal: up, tangent, bitangent } = planeAxes({ normal: axis });
  const out = add(scale(tangent, Math.cos(around)), scale(bitangent, Math.sin(around)));
  const normal = add(scale(out, Math.cos(tubeAngle)), scale(up, Math.sin(tubeAngle)));
  return { point: addScaled(addScaled(center, out, radius), normal, tube), normal };
}

/** How far a point is from the surface. */
const offSurface = (shape: Ring, point: Vec3): number => torus.clearance(shape, point);

const isInside = (shape: Ring, point: Vec3): boolean => torus.side(shape, point) < 0;

test('a hit lies on the torus, nothing of it is before, and the normal is that of the tube', () => {
  fc.assert(
    fc.property(ring, triple, direction, (shape, origin, d) => {
      const t = torusDistance(shape, { origin, direction: d }, false);
      const end = Math.min(t, 20);
      for (let i = 0; i < 200; i++) {
        const before = addScaled(origin, d, (end * (i + 0.5)) / 200);
        if (offSurface(shape, before) > 1e-9) assert.equal(isInside(shape, before), isInside(shape, origin));
      }
      if (t > 20) return;
      const point = addScaled(origin, d, t);
      assert.ok(offSurface(shape, point) < 1e-12);
      const inner = addScaled(point, torusNormal(shape, point), -shape.tube);
      assert.ok(Math.abs(offSurface({ ...shape, tube: 0 }, inner)) < 1e-11);
    }),
  );
});

test('a ray that grazes meets the torus where the torus is, or not at all', () => {
  const random = numbers(1);
  for (let i = 0; i < 20_000; i++) {
    const ray = grazingRay(random, 2 ** -53);
    const off = offTorus(ray, torusDistance(ray.shape, ray, false), 2 ** -53);
    assert.ok(off < 8, `${JSON.stringify(ray)}: ${off} roundings off`);
  }
});

test('turned about its axis, or seen from the other side of it, a torus is the same', () => {
  fc.assert(
    fc.property(ring, direction, angle, (shape, d, turn) => {
      const { normal: up, tangent, bitangent } = planeAxes({ normal: shape.axis });
      const turned = (v: Vec3): Vec3 => {
        const [x, y] = [dot(v, tangent), dot(v, bitangent)];
        const level = add(
          scale(tangent, x * Math.cos(turn) - y * Math.sin(turn)),
          scale(bitangent, x * Math.sin(turn) + y * Math.cos(turn)),
        );
        return addScaled(level, up, dot(v, up));
      };
      // Right through the tube, so that rounding makes no difference to whether it is met.
      const target = addScaled(place(shape, turn, 1).point, place(shape, turn, 1).normal, -0.5 * shape.tube);
      const origin = addScaled(target, d, -10);
      const t = torusDistance(shape, { origin, direction: d }, false);
      const away = subtract(origin, shape.center);
      const again = torusDistance(
        { ...shape, axis: negate(shape.axis) },
        { origin: add(shape.center, turned(away)), direction: turned(d) },
        false,
      );
      const there = addScaled(origin, d, t);
      // A ray that grazes has fewer digits.
      const grazing = Math.abs(dot(torusNormal(shape, there), d));
      assert.ok(Math.abs(t - again) * grazing < 1e-11 || grazing < 1e-3, `${t} ${again}`);
      assert.ok(t < 10);
    }),
  );
});

test('a ray that leaves the torus meets it again through the hole, but not where it leaves', () => {
  fc.assert(
    fc.property(ring, angle, angle, direction, (shape, around, tubeAngle, d) => {
      const { point, normal } = place(shape, around, tubeAngle);
      if (Math.abs(dot(normal, d)) < 0.05) return;
      const t = torusDistance(shape, { origin: point, direction: d }, true);
      // What it meets, a ray meets that starts a little farther on.
      const ahead = 1e-6 * shape.tube;
      const from = addScaled(point, d, ahead);
      const expected = torusDistance(shape, { origin: from, direction: d }, false) + ahead;
      assert.ok(t === expected || Math.abs(t - expected) < 1e-7 * shape.radius, `${t} ${expected}`);
      if (dot(normal, d) < 0) assert.ok(t < 2 * (shape.radius + shape.tube));
    }),
  );
  const shape: Ring = { type: 'torus', center: [0, 0, 0], axis: [0, 1, 0], radius: 2, tube: 0.5 };
  const t = (origin: Vec3, direction: Vec3) => torusDistance(shape, { origin, direction }, true);
  assert.equal(t([1.5, 0, 0], [-1, 0, 0]), 3);
  assert.equal(t([2.5, 0, 0], [1, 0, 0]), Number.POSITIVE_INFINITY);
  assert.equal(t([2.5, 0, 0], [-1, 0, 0]), 1);
  assert.equal(t([2, 0.5, 0], [0, 1, 0]), Number.POSITIVE_INFINITY);
});

test('a ray along the axis goes through the hole', () => {
  const shape: Ring = { type: 'torus', center: [1, 2, 3], axis: [0, 0, 2], radius: 1, tube: 0.25 };
  const t = (x: number) => torusDistance(shape, { origin: [1 + x, 2, 8], direction: [0, 0, -1] }, false);
  assert.equal(t(0), Number.POSITIVE_INFINITY);
  const fromCenter = { origin: shape.center, direction: [0, 0, 1] as const };
  assert.equal(torusDistance(shape, fromCenter, false), Number.POSITIVE_INFINITY);
  assert.equal(t(0.74), Number.POSITIVE_INFINITY);
  assert.ok(Math.abs(t(1) - 4.75) < 1e-15);
  assert.equal(t(1.26), Number.POSITIVE_INFINITY);
});

test('at scales of powers of two the distances are the same but for the scale', () => {
  fc.assert(
    fc.property(ring, triple, direction, fc.integer({ min: -150, max: 150 }), (shape, start, d, k) => {
      // Nothing so small that its scale makes a denormal number of it.
      const origin = start.map((x) => (Math.abs(x) < 1e-9 ? 0 : x)) as unknown as Vec3;
      const s = 2 ** k;
      const scaled = { ...shape, center: scale(shape.center, s), radius: shape.radius * s, tube: shape.tube * s };
      const t = torusDistance(scaled, { origin: scale(origin, s), direction: d }, false);
      assert.equal(t / s, torusDistance(shape, { origin, direction: d }, false));
    }),
  );
});

test('U runs along the ring, V around the tube from its outer circle, first up the axis', () => {
  fc.assert(
    fc.property(ring, real(-3, 3), real(-3, 3), (shape, around, tubeAngle) => {
      const [u, v] = torusLengths(shape, place(shape, around, tubeAngle).point);
      assert.ok(Math.abs(u - shape.radius * around) < 1e-11);
      assert.ok(Math.abs(v - shape.tube * tubeAngle) < 1e-11);
    }),
  );
});

test('its bounds hold all of it, and touch it', () => {
  fc.assert(
    fc.property(ring, angle, angle, (shape, around, tubeAngle) => {
      const { min, max } = torus.bounds(shape) as { min: Vec3; max: Vec3 };
      const { point } = place(shape, around, tubeAngle);
      point.forEach((x, i) => {
        assert.ok(x > (min[i] as number) - 1e-12 && x < (max[i] as number) + 1e-12);
      });
      // From far up the x axis, the point of the ring that is highest there, and the tube on top of it.
      const { normal } = planeAxes({ normal: shape.axis });
      const up = subtract([1, 0, 0], scale(normal, normal[0]));
      if (length(up) < 1e-3) return;
      const top = add(addScaled(shape.center, normalize(up), shape.radius), [shape.tube, 0, 0]);
      assert.ok(Math.abs(top[0] - max[0]) < 1e-12);
    }),
  );
});

test('a tube that is as thick as its ring is refused', () => {
  const problems = (node: object) => {
    try {
      parseScene({ objects: [{ type: 'torus', ...node }] });
    } catch (error) {
      return (error as SceneError).problems.map(({ message }) => message);
    }
    return [];
  };
  const expected = ['tube must be below the radius, not 2 for a radius of 1: it would fill its own hole'];
  assert.deepEqual(problems({ tube: 2 }), expected);
  assert.equal(problems({ radius: 0.25 }).length, 1);
  assert.deepEqual(problems({ radius: 0.5 }), []);
});

const lamp = { type: 'point', position: [0, 4, 0] };
const required = (scene: object) => requirements(resolveScene(parseScene(scene)), { bounces: 3 });

test('one torus alone can stand in its own light, and be seen in itself', () => {
  const { features } = required({ lights: [lamp], objects: [{ type: 'torus' }] });
  assert.ok(features.includes('shadows') && features.includes('reflections'));
});

test('what is packed of a torus is a number wherever the camera is', () => {
  const places: Vec3[] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 5, 0],
    [1.25, 0, 0],
    [1e-30, 0, 0],
    [1e9, 3, 1],
  ];
  for (const position of places) {
    for (const s of [2 ** -100, 1, 2 ** 100]) {
      const camera = { position: scale(position, s), target: scale([100, 3, 2], s) };
      const objects = [{ type: 'torus', radius: s, tube: s / 4, checker: 'red', checkerSize: s }];
      const lights = [{ type: 'directional' }];
      const scene = resolveScene(parseScene({ camera, lights, objects }));
      const needed = requirements(scene, { bounces: 3 });
      const floats = new Float32Array(packScene(scene, needed, generateShader(needed).sceneBlock));
      assert.ok(floats.every(Number.isFinite), `${position} ${s}`);
    }
  }
});

test('every function of its shader is called, and next to it more of them', () => {
  const functions = (position: Vec3) => {
    const scene = { camera: { position }, lights: [lamp], objects: [{ type: 'torus', checker: 'red' }] };
    const glsl = generateShader(required(scene)).fragment;
    const names = [...glsl.matchAll(/^\w+ (torus\w+)\([^;]*\) \{$/gm)].map(([, name]) => name as string);
    for (const name of names) assert.ok(glsl.split(`${name}(`).length > 2, name);
    return names;
  };
  const [near, far] = [functions([0, 0, 1.25001]), functions([0, 1, 4])];
  assert.ok(near.includes('torusTaylor') && !far.includes('torusTaylor') && far.includes('torusCells'));
});
