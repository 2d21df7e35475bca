// Scenes as another renderer describes them, in our words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type EnvironmentImage, imageTable, type Vec3 } from '@ray-scene/core';
import { environmentImage } from '../../packages/core/src/reference/light/environment-image.ts';
import { normalize } from '../../packages/core/src/vector.ts';
import type { NeutralMaterial, NeutralObject, NeutralScene } from '../truth/images/neutral-scene.ts';
import { environmentImages } from '../truth/images/translate-environment.ts';
import { translateScene } from '../truth/images/translate-scene.ts';

const empty: NeutralScene = {
  name: 'made up',
  width: 4,
  height: 3,
  camera: { type: 'perspective', origin: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], vfovDegrees: 40 },
  materials: { grey: { type: 'lambert', albedo: [0.5, 0.5, 0.5] } },
  objects: [],
  lights: [],
  environment: null,
  integrator: { type: 'path', mitsubaMaxDepth: 2 },
};

const ball: NeutralObject = { shape: 'sphere', center: [0, 0, 0], radius: 1, material: 'grey' };
const floor: NeutralObject = {
  shape: 'rectangle',
  corner: [-4, 0, 4],
  edgeU: [8, 0, 0],
  edgeV: [0, 0, -8],
  material: 'grey',
};

interface Ours {
  readonly objects: readonly { readonly [field: string]: unknown }[];
  readonly [field: string]: unknown;
}

function ours(changes: Partial<NeutralScene>): Ours {
  const translated = translateScene({ ...empty, ...changes });
  assert.ok(translated.skipped === undefined, translated.skipped);
  return translated.scene as Ours;
}

const reason = (changes: Partial<NeutralScene>): string | undefined => translateScene({ ...empty, ...changes }).skipped;

const with1 = (material: NeutralMaterial, object: NeutralObject = ball): Partial<NeutralScene> => ({
  materials: { it: material },
  objects: [{ ...object, material: 'it' }],
});

test('depth counts segments there and surfaces here', () => {
  const bounces = (type: string, mitsubaMaxDepth?: number) => {
    const translated = translateScene({
      ...empty,
      integrator: { type, ...(mitsubaMaxDepth === undefined ? {} : { mitsubaMaxDepth }) },
    });
    return translated.skipped ?? translated.bounces;
  };
  assert.equal(bounces('path', 1), 0);
  assert.equal(bounces('path', 16), 15);
  assert.equal(bounces('direct'), 1);
  assert.equal(bounces('path', -1), 64);
  assert.match(String(bounces('volpath', 3)), /volpath/);
});

test('without surroundings the background is black', () => {
  assert.deepEqual(ours({}).background, [0, 0, 0]);
  assert.equal(ours({}).environment, undefined);
  const sky = ours({ environment: { type: 'constant', radiance: [1, 2, 3] } });
  assert.deepEqual([sky.background, sky.environment], ['environment', { color: [1, 2, 3] }]);
});

test('an image of the surroundings has our places of texels, and shows the same in the same directions', async () => {
  const [width, height] = [8, 5];
  const data = Float32Array.from({ length: 3 * width * height }, (_, i) => ((i * 7919) % 101) / 101);
  const environment = { type: 'envmap', file: 'sky', width, height };
  const scene = ours({ environment });
  assert.deepEqual(scene.environment, { src: 'sky', rotation: -90 });
  const images = await environmentImages({ ...empty, environment }, async () => data.slice().buffer);
  const image = imageTable(images.get('sky') as EnvironmentImage);
  const theirs = ([x, y, z]: Vec3): number => {
    const u = Math.atan2(x, -z) / (2 * Math.PI);
    const X = (u - Math.floor(u)) * width - 0.5;
    const Y = (Math.acos(y) / Math.PI) * (height - 1);
    const [i, j] = [Math.floor(X), Math.min(Math.floor(Y), height - 2)];
    const at = (column: number, row: number) => data[3 * (row * width + ((column + width) % width))] as number;
    const row = (k: number) => at(i, k) + (at(i + 1, k) - at(i, k)) * (X - i);
    return row(j) + (row(j + 1) - row(j)) * (Y - j);
  };
  for (let k = 0; k < 200; k++) {
    const direction = normalize([Math.sin(12.3 * k), Math.sin(4.7 * k + 1), Math.sin(7.1 * k + 2)]);
    const [found] = environmentImage(image, -0.25, direction);
    assert.ok(Math.abs(found - theirs(direction)) < 1 / 40, `${direction}: ${found}, ${theirs(direction)}`);
  }
});

test('a turned box is a box in a group about its centre', () => {
  const box: NeutralObject = { shape: 'box', min: [0, 0, 0], max: [2, 4, 6], rotateYDegrees: 18, material: 'grey' };
  const [group] = ours({ objects: [box] }).objects as readonly [Ours];
  assert.deepEqual([group.type, group.position, group.rotation], ['group', [1, 2, 3], [0, 18, 0]]);
  const [inner] = group.objects as readonly [Ours['objects'][number]];
  assert.deepEqual([inner.type, inner.center, inner.size], ['box', [0, 0, 0], [2, 4, 6]]);
});

test('a spot that is full up to the beam width fades over the rest', () => {
  const light = {
    type: 'spot',
    position: [0, 4, 0],
    target: [0, 0, 0],
    intensity: [5, 6, 7],
    cutoffDegrees: 24,
    beamWidthDegrees: 18,
  } as const;
  const [spot] = ours({ lights: [light] }).lights as Ours['objects'];
  assert.deepEqual([spot?.angle, spot?.penumbra, spot?.color], [24, 0.25, [5, 6, 7]]);
});

test('emission shines to the outside unless the scene says otherwise', () => {
  const [out, inner] = ours({
    objects: [
      { ...ball, emission: [9, 8, 7] },
      { ...ball, emission: [9, 8, 7], emissionSide: 'inside' },
    ],
  }).objects;
  assert.deepEqual([out?.emission, out?.emissionSide, inner?.emissionSide], [[9, 8, 7], 'front', 'back']);
});

test('checkers count cells from the corner, along the edges', () => {
  const checker = { cell: 0.5, color0: [1, 1, 1], color1: [0, 0, 0] } as const;
  const material: NeutralMaterial = { type: 'lambert', checker };
  const [quad] = ours(with1(material, floor)).objects;
  assert.deepEqual([quad?.color, quad?.checker, quad?.checkerSize], [[1, 1, 1], [0, 0, 0], 0.5]);
  const [turned] = ours(with1(material, { ...floor, edgeU: [-8, 0, 0] })).objects;
  assert.deepEqual(
    [turned?.color, turned?.checker],
    [
      [0, 0, 0],
      [1, 1, 1],
    ],
  );
  assert.match(String(reason(with1(material, { ...floor, edgeU: [8, 0, 1] }))), /checker/);
  assert.match(String(reason(with1(material))), /checker/);
});

test('a medium is what contains it, or there is a reason not to render the scene', () => {
  const glass: NeutralMaterial = { type: 'dielectric', iorInside: 1.5, iorOutside: 1 };
  const air: NeutralMaterial = { type: 'dielectric', iorInside: 1, iorOutside: 1.5 };
  const shell = {
    materials: { glass, air },
    objects: [
      { ...ball, material: 'glass' },
      { ...ball, radius: 0.5, material: 'air' },
    ],
  };
  assert.deepEqual(
    ours(shell).objects.map(({ ior, transmission }) => [ior, transmission]),
    [
      [1.5, 1],
      [1, 1],
    ],
  );
  assert.match(String(reason(with1(air))), /medium/);
  assert.match(String(reason(with1(glass, floor))), /interface/);
});

const indices = (materials: NeutralScene['materials'], ...objects: NeutralObject[]): readonly unknown[] =>
  ours({ materials, objects }).objects.map(({ ior, objects: inner }) =>
    inner ? (inner as Ours['objects'])[0]?.ior : ior,
  );
const medium = (iorInside: number, iorOutside: number): NeutralMaterial => ({
  type: 'dielectric',
  iorInside,
  iorOutside,
});

test('what is inside of glass is so in boxes and cylinders too, turned, and where they touch', () => {
  const materials = { glass: medium(1.5, 1), water: medium(1.33, 1.5), air: medium(1, 1.33) };
  const small = { ...ball, center: [0.4, 0, 0], radius: 0.2, material: 'air' } as const;
  const box: NeutralObject = { shape: 'box', min: [-2, -1, -1], max: [2, 1, 1], rotateYDegrees: 30, material: 'glass' };
  const can: NeutralObject = { shape: 'cylinder', a: [-0.7, 0, 0], b: [0.7, 0, 0], radius: 0.6, material: 'water' };
  assert.deepEqual(indices(materials, small, can, box), [1, 1.33, 1.5]);
  // Water that reaches out of the box is not in it, and less dense than what it says is around it.
  const wide = { ...can, radius: 1.1 };
  assert.match(String(reason({ materials, objects: [wide, box] })), /medium/);
  const touching = { ...ball, center: [Math.fround(0.3), 0, 0], radius: Math.fround(0.7), material: 'water' } as const;
  assert.deepEqual(indices(materials, touching, { ...ball, material: 'glass' }), [1.33, 1.5]);
});

test('what counts of indices is their ratio to what is around everything', () => {
  const materials = { glass: medium(1.8, 1.2), core: medium(2.4, 1.8), air: medium(1, 1.8) };
  const core = { ...ball, radius: 0.5, material: 'core' };
  const [inner, outer] = indices(materials, core, { ...ball, material: 'glass' });
  assert.ok(Math.abs((inner as number) - 2) < 1e-12 && Math.abs((outer as number) - 1.5) < 1e-12, `${inner}, ${outer}`);
  const thinner = {
    materials,
    objects: [
      { ...core, material: 'air' },
      { ...ball, material: 'glass' },
    ],
  };
  assert.match(String(reason(thinner)), /medium of 0.83/);
});

test('what there are no words for is a reason, not an error', () => {
  const reasons = [
    { objects: [{ shape: 'mesh', material: 'grey' }] },
    { objects: [{ ...ball, material: 'missing' }] },
    { objects: [{ shape: 'sphere', material: 'grey' }] },
    { objects: [{ shape: 'cylinder', a: [0, 0, 0], b: [0, 1, 0], radius: 1, capped: false, material: 'grey' }] },
    { lights: [{ type: 'projector' }] },
    { camera: { ...empty.camera, type: 'fisheye' } },
    { environment: { type: 'sunsky' } },
    with1({ type: 'mirror', reflectance: [0.9, 0.9, 0.9] }),
    with1({ type: 'plastic' }),
    with1({ type: 'constructor' }),
  ] satisfies Partial<NeutralScene>[];
  for (const changes of reasons) assert.ok(reason(changes), JSON.stringify(changes));
});
