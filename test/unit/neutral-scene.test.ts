// What the truth's description of a scene says of cameras, lights and checkers, computed here from its own words, against
// the reference's picture of our translation; and scenes with whatever else it allows, which must all be rendered.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parseScene, type Vec3 } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';
import fc from 'fast-check';
import { ownPlace, pixelSampler } from '../../packages/core/src/random.ts';
import { add, addScaled, cross, dot, length, normalize, scale, subtract } from '../../packages/core/src/vector.ts';
import type {
  NeutralCamera,
  NeutralLight,
  NeutralMaterial,
  NeutralObject,
  NeutralScene,
} from '../truth/images/neutral-scene.ts';
import { translateScene } from '../truth/images/translate-scene.ts';

/** A floor at y = 0; every scene has one. */
const CORNERS: readonly Pick<NeutralObject, 'corner' | 'edgeU' | 'edgeV'>[] = [
  { corner: [-8, 0, 8], edgeU: [16, 0, 0], edgeV: [0, 0, -16] },
  { corner: [8, 0, 8], edgeU: [0, 0, -16], edgeV: [-16, 0, 0] },
  { corner: [-8, 0, -8], edgeU: [0, 0, 16], edgeV: [16, 0, 0] },
  { corner: [8, 0, -8], edgeU: [-16, 0, 0], edgeV: [0, 0, 16] },
];

const between = (min: number, max: number): fc.Arbitrary<number> =>
  fc.double({ min, max, noNaN: true }).map((x) => Math.fround(x));
const vectorOf = (x: fc.Arbitrary<number>, y = x, z = x): fc.Arbitrary<Vec3> => fc.tuple(x, y, z);
const colors = vectorOf(between(0.05, 1));
const oneOf = <T>(...choices: readonly T[]): fc.Arbitrary<T> => fc.constantFrom(...choices);

const view = {
  origin: vectorOf(between(-3, 3), between(2, 5), between(4, 7)),
  target: vectorOf(between(-1, 1), between(0, 1), between(-1, 1)),
  up: oneOf<Vec3>([0, 1, 0], [0.25, 1, 0.5]),
};
const plainCameras: fc.Arbitrary<NeutralCamera> = fc.oneof(
  fc.record({ type: fc.constant('perspective'), ...view, vfovDegrees: between(10, 60) }),
  fc.record({ type: fc.constant('orthographic'), ...view, viewHeight: between(1, 4) }),
);
const cameras: fc.Arbitrary<NeutralCamera> = fc.oneof(
  plainCameras,
  fc.record({
    type: fc.constant('thinLens'),
    ...view,
    vfovDegrees: between(10, 60),
    apertureRadius: between(0.01, 0.5),
    focusDistance: between(2, 9),
  }),
);

const above = vectorOf(between(-3, 3), between(2, 6), between(-3, 3));
const lights: fc.Arbitrary<NeutralLight> = fc.oneof(
  fc.record({ type: fc.constant('point'), position: above, intensity: vectorOf(between(1, 60)) }),
  fc.record({
    type: fc.constant('directional'),
    direction: vectorOf(between(-1, 1), between(-2, -0.5), between(-1, 1)),
    irradiance: vectorOf(between(0.1, 5)),
  }),
  fc
    .record({
      position: above,
      target: vectorOf(between(-1, 1), fc.constant(0), between(-1, 1)),
      intensity: vectorOf(between(1, 60)),
      cutoffDegrees: between(5, 80),
      beam: fc.option(oneOf(0, 0.25, 0.5, 0.875), { nil: undefined }),
    })
    .map(({ beam, ...light }) => ({
      type: 'spot',
      ...light,
      ...(beam === undefined ? {} : { beamWidthDegrees: Math.fround(beam * light.cutoffDegrees) }),
    })),
);

const sizes = fc.record({ width: oneOf(4, 7), height: oneOf(3, 6) });

interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}

/** Through a place of the picture, counted in pixels from its upper left corner; as section 3 of data/README.md has it. */
function rayOf(camera: NeutralCamera, width: number, height: number, column: number, row: number): Ray {
  const f = normalize(subtract(camera.target, camera.origin));
  const r = normalize(cross(f, camera.up));
  const u = cross(r, f);
  const [sx, sy] = [(2 * column) / width - 1, 1 - (2 * row) / height];
  const aside = (half: number): Vec3 => add(scale(r, sx * half * (width / height)), scale(u, sy * half));
  return camera.type === 'orthographic'
    ? { origin: add(camera.origin, aside((camera.viewHeight as number) / 2)), direction: f }
    : {
        origin: camera.origin,
        direction: normalize(add(f, aside(Math.tan(((camera.vfovDegrees as number) * Math.PI) / 360)))),
      };
}

/** On a surface that faces up, without shadows. */
function irradiance(light: NeutralLight, p: Vec3): Vec3 {
  if (light.type === 'directional') {
    return scale(light.irradiance as Vec3, Math.max(0, -normalize(light.direction as Vec3)[1]));
  }
  const way = subtract(p, light.position as Vec3);
  const even = scale(light.intensity as Vec3, Math.max(0, -way[1]) / length(way) ** 3);
  if (light.type === 'point') return even;
  const axis = normalize(subtract(light.target as Vec3, light.position as Vec3));
  const angle = (Math.acos(Math.min(1, dot(axis, way) / length(way))) * 180) / Math.PI;
  const cutoff = light.cutoffDegrees as number;
  const beam = light.beamWidthDegrees ?? 0.75 * cutoff;
  return scale(even, Math.min(1, Math.max(0, (cutoff - angle) / (cutoff - beam))));
}

function floorColor({ corner = [0, 0, 0] }: NeutralObject, material: NeutralMaterial, [x, , z]: Vec3): Vec3 {
  if (!material.checker) return material.albedo as Vec3;
  const { cell, color0, color1 } = material.checker;
  const cells = Math.floor((x - corner[0]) / cell) + Math.floor((corner[2] - z) / cell);
  return cells % 2 === 0 ? color0 : color1;
}

const floorMaterials: fc.Arbitrary<NeutralMaterial> = fc.oneof(
  fc.record({ type: fc.constant('lambert'), albedo: colors }),
  fc.record({
    type: fc.constant('lambert'),
    checker: fc.record({ cell: oneOf(0.25, 0.5, 1), color0: colors, color1: colors }),
  }),
);

const floorScenes = fc
  .record({
    camera: plainCameras,
    lights: fc.array(lights, { minLength: 1, maxLength: 3 }),
    material: floorMaterials,
    place: oneOf(...CORNERS),
    ...{ size: sizes },
  })
  .map(
    ({ camera, lights, material, place, size }): NeutralScene => ({
      name: 'a floor',
      ...size,
      camera,
      lights,
      materials: { floor: material },
      objects: [{ shape: 'rectangle', ...place, material: 'floor' }],
      environment: null,
      integrator: { type: 'direct' },
    }),
  );

test('a floor under lamps is as bright as the description says, pixel by pixel', () => {
  fc.assert(
    fc.property(floorScenes, (neutral) => {
      const { width, height, objects, materials } = neutral;
      const translated = translateScene(neutral);
      assert.ok(translated.skipped === undefined, translated.skipped);
      const { scene, bounces } = translated;
      const settings = { width, height, bounces, samples: 1, seed: 1 };
      // One of the lamps is asked at a time: each in a scene of its own.
      const pictures = neutral.lights.map((_, i) => {
        const { lights } = scene as { readonly lights: readonly object[] };
        return renderReference(parseScene({ ...scene, lights: [lights[i]] }), settings).data;
      });
      for (let pixel = 0; pixel < width * height; pixel++) {
        const [column, row] = [pixel % width, Math.floor(pixel / width)];
        const [right, down] = ownPlace(pixelSampler(column, height - 1 - row, 0, settings.seed));
        const { origin, direction } = rayOf(neutral.camera, width, height, column + right, row + down);
        const t = -origin[1] / direction[1];
        const p = addScaled(origin, direction, t);
        const floor = objects[0] as NeutralObject;
        const isFloor = t > 0 && Math.max(Math.abs(p[0]), Math.abs(p[2])) < 8;
        const color = floorColor(floor, materials.floor as NeutralMaterial, p);
        neutral.lights.forEach((light, i) => {
          const expected = irradiance(light, p).map((e, k) => (isFloor ? (e * (color[k] as number)) / Math.PI : 0));
          const found = [0, 1, 2].map((k) => pictures[i]?.[4 * pixel + k] as number);
          const close = found.every(
            (x, k) => Math.abs(x - (expected[k] as number)) <= 1e-7 * (1 + (expected[k] as number)),
          );
          assert.ok(close, `${light.type}, pixel ${column} ${row}: ${found}, not ${expected}`);
        });
      }
    }),
    { numRuns: 60 },
  );
});

const places = vectorOf(between(-1.5, 1.5), between(0.3, 1.2), between(-1.5, 1.5));
const emission = fc.option(vectorOf(between(0, 9)), { nil: undefined });
const shapes: fc.Arbitrary<Omit<NeutralObject, 'material'>> = fc.oneof(
  fc.record({
    shape: fc.constant('sphere'),
    center: places,
    radius: between(0.1, 0.8),
    emissionSide: oneOf('outside', 'inside'),
  }),
  fc.record({
    shape: fc.constant('rectangle'),
    corner: places,
    edgeU: oneOf<Vec3>([1, 0, 0.5]),
    edgeV: oneOf<Vec3>([0, 0.7, 0]),
  }),
  fc.record({
    shape: fc.constant('disc'),
    center: places,
    normal: oneOf<Vec3>([0, 1, 0], [1, 2, -1]),
    radius: between(0.1, 0.8),
  }),
  fc.record({ shape: fc.constant('triangle'), a: places, b: oneOf<Vec3>([2, 0.5, 0]), c: oneOf<Vec3>([0, 2, -2]) }),
  fc
    .record({ min: places, size: vectorOf(between(0.1, 0.8)), rotateYDegrees: between(-90, 90) })
    .map(({ min, size, rotateYDegrees }) => ({ shape: 'box', min, max: add(min, size), rotateYDegrees })),
  fc
    .record({ a: places, along: oneOf<Vec3>([0, 1, 0], [0.5, 0.25, 1]), radius: between(0.05, 0.4) })
    .map(({ a, along, radius }) => ({ shape: 'cylinder', a, b: add(a, along), radius, capped: true })),
);
const materials: fc.Arbitrary<NeutralMaterial> = fc.oneof(
  fc.record({ type: fc.constant('lambert'), albedo: colors }),
  fc.record({ type: fc.constant('mirror'), reflectance: fc.constant<Vec3>([1, 1, 1]) }),
  fc.record({ type: fc.constant('ggxConductor'), alpha: between(0.01, 1), reflectance: fc.constant<Vec3>([1, 1, 1]) }),
);
/** A ball of glass with another medium in its middle. */
const glassBalls = fc
  .record({ outer: between(1.1, 2.4), inner: between(1, 2.4), alpha: oneOf(0, 0.2) })
  .map(({ outer, inner, alpha }) => {
    const kind = alpha > 0 ? { type: 'roughDielectric', alpha } : { type: 'dielectric' };
    return {
      materials: {
        outer: { ...kind, iorInside: outer, iorOutside: 1 },
        inner: { ...kind, iorInside: inner, iorOutside: outer },
      },
      objects: [
        { shape: 'sphere', center: [0, 3, 0] as Vec3, radius: 0.8, material: 'outer' },
        { shape: 'sphere', center: [0.1, 3, 0] as Vec3, radius: 0.5, material: 'inner' },
      ],
    };
  });

const anyScene = fc
  .record({
    size: sizes,
    camera: cameras,
    lights: fc.array(lights, { maxLength: 2 }),
    floor: floorMaterials,
    place: oneOf(...CORNERS),
    things: fc.array(fc.tuple(shapes, materials, emission), { minLength: 1, maxLength: 5 }),
    glass: fc.option(glassBalls, { nil: { materials: {}, objects: [] } }),
    sky: fc.option(colors, { nil: undefined }),
    integrator: oneOf<NeutralScene['integrator']>(
      { type: 'direct' },
      ...[1, 2, 3, 8, 20, -1].map((mitsubaMaxDepth) => ({ type: 'path', mitsubaMaxDepth })),
    ),
  })
  .map(
    ({ size, camera, lights, floor, place, things, glass, sky, integrator }): NeutralScene => ({
      name: 'anything',
      ...size,
      camera,
      lights,
      materials: {
        floor,
        ...Object.fromEntries(things.map(([, material], i) => [`m${i}`, material])),
        ...glass.materials,
      },
      objects: [
        { shape: 'rectangle', ...place, material: 'floor' },
        ...things.map(([shape, , light], i) => ({
          ...shape,
          material: `m${i}`,
          ...(light ? { emission: light } : {}),
        })),
        ...glass.objects,
      ],
      environment: sky ? { type: 'constant', radiance: sky } : null,
      integrator,
    }),
  );

test('scenes of all that the description allows are translated and rendered', () => {
  fc.assert(
    fc.property(anyScene, (neutral) => {
      const translated = translateScene(neutral);
      assert.ok(translated.skipped === undefined, translated.skipped);
      const { width, height } = neutral;
      const { scene, bounces } = translated;
      const { data } = renderReference(parseScene(scene), { width, height, bounces, samples: 2 });
      assert.ok(data.every((value) => value >= 0 && value < Number.POSITIVE_INFINITY));
    }),
    { numRuns: 100 },
  );
});
