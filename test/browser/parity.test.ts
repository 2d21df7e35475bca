// The GPU's pictures against the f64 reference, sample by sample: both shoot the same rays, what differs is rounding.

import { parseScene, type Scene } from '@ray-scene/core';
import { expectAgreement, SIDE } from './agreement.ts';

const agree = (what: string, scene: Scene, bounces = 6, samples = 1): void =>
  expectAgreement(what, scene, { width: SIDE, height: SIDE, bounces, samples });

async function sceneFile(name: string): Promise<Scene> {
  return parseScene(await (await fetch(`/examples/scenes/${name}.json`)).text());
}

describe('GPU against reference', function () {
  this.timeout(60_000);

  for (const name of [
    'classic',
    'eclipse',
    'groups',
    'hello',
    'metals',
    'planes',
    'planet',
    'rings',
    'shells',
    'studio',
  ]) {
    it(`draws ${name} alike`, async () =>
      name === 'classic' ? agree(name, await sceneFile(name), 10, 4) : agree(name, await sceneFile(name)));
  }

  const ball = { type: 'sphere', center: [0, 0, 0], radius: 1 };
  const floor = { type: 'plane', point: [0, -1, 0], checker: 'black' };
  const sun = { type: 'directional', direction: [1, -2, -1], intensity: 3 };
  const lamp = { type: 'point', position: [2, 3, 4], intensity: 60 };
  const camera = { position: [0.5, 1, 5] };

  /** A shape moved, by whichever places it has. */
  const placed = ({ type, ...shape }: { type: string }, at: readonly number[]): object => {
    const places: { readonly [type: string]: object } = {
      quad: { corner: [0, 0, 0] },
      cylinder: { base: [0, 0, 0], top: [0.2, 0.6, 0.1] },
      cone: { base: [0, 0, 0], tip: [0.2, 0.6, 0.1] },
      triangle: { a: [0, 0, 0], b: [0.6, 0.1, 0], c: [0.2, 0.6, 0.2] },
    };
    const moved = Object.entries(places[type] ?? { center: [0, 0, 0] }).map(([name, place]) => [
      name,
      (place as number[]).map((x, i) => x + (at[i] as number)),
    ]);
    return { type, ...shape, ...Object.fromEntries(moved) };
  };

  const scenes: { readonly [what: string]: object } = {
    'one sphere and one directional light': { camera, lights: [sun], objects: [ball] },
    'a look from inside a mirror ball': {
      camera: { position: [0, 0, 1.5], target: [0, 0, 0], fov: 90 },
      lights: [lamp, { type: 'point', position: [0.5, 1, 1], intensity: 5 }],
      environment: { color: 'white' },
      objects: [
        { ...ball, radius: 2, metalness: 0.5, roughness: 0.3 },
        { ...ball, radius: 0.5, color: 'gold' },
      ],
    },
    'a lamp inside a ball, which lights nothing outside': {
      camera,
      lights: [sun, { ...lamp, position: [0, 0, 0.5] }],
      objects: [ball, floor],
    },
    'a look from below the floor': {
      camera: { position: [0, -3, 5] },
      lights: [lamp, { ...lamp, position: [1, -4, 3] }],
      objects: [ball, floor],
    },
    'a tilted plane with a turned pattern': {
      camera,
      lights: [lamp],
      objects: [ball, { ...floor, normal: [0.3, 1, 0.2], tangent: [1, 0, 1], checkerSize: 0.4 }],
    },
    'light that does not fade beside light that does': {
      camera,
      lights: [lamp, { ...lamp, position: [-3, 2, 1], intensity: 2, decay: 0 }],
      objects: [ball, floor],
    },
    'tinted and weak reflections': {
      camera,
      lights: [sun],
      objects: [
        { ...ball, specularColor: [1, 0.2, 0.1], ior: 3 },
        { ...floor, specular: 0.3 },
      ],
    },
    'surfaces without any reflection': {
      camera,
      lights: [sun, lamp],
      objects: [
        { ...ball, specular: 0 },
        { ...floor, specular: 0 },
      ],
    },
    'metal only': {
      camera,
      lights: [sun],
      environment: { top: 'skyblue', bottom: 'white' },
      objects: [
        { ...ball, metalness: 1, roughness: 0 },
        { type: 'plane', point: [0, -1, 0], metalness: 1, color: '#c85' },
      ],
    },
    'a checkered ball': { camera, lights: [lamp], objects: [{ ...ball, checker: 'black', checkerSize: 0.3 }, floor] },
    'a look from inside a mirror ring': {
      camera: { position: [2, 0, 0], target: [1.9, 0.05, -1], fov: 80 },
      lights: [{ ...lamp, position: [0, 0.1, 2], intensity: 9 }],
      environment: { color: 'white' },
      objects: [
        { type: 'torus', radius: 2, tube: 0.6, metalness: 0.5, roughness: 0.3, checker: 'red', checkerSize: 0.4 },
        { ...ball, center: [1.6, 0, -1.2], radius: 0.2, color: 'gold' },
      ],
    },
    'a ball on a ring as large as a planet': {
      camera: { position: [0, 1.7, 4], target: [0, 0.8, 0] },
      lights: [{ type: 'directional', direction: [-2, -2, -1], intensity: 3 }],
      objects: [
        { type: 'torus', center: [6e6, -0.96e6, -0.28e6], axis: [0, 0.96, 0.28], radius: 6e6, tube: 1e6, specular: 0 },
        { ...ball, center: [0, 0.48, 0.14], radius: 0.5, color: 'crimson' },
      ],
    },
    'more rings than are written out one by one': {
      camera: { position: [0, 4, 9] },
      lights: [lamp, sun],
      environment: { color: [0.1, 0.1, 0.2] },
      objects: [
        floor,
        ...Array.from({ length: 10 }, (_, i) => ({
          type: 'torus',
          center: [2.5 * Math.cos(i), i / 8, 2.5 * Math.sin(i)],
          axis: [Math.sin(3 * i), Math.cos(3 * i), Math.cos(i)],
          radius: 0.5 + i / 20,
          tube: 0.2,
          metalness: i % 2,
        })),
      ],
    },
    'nothing at all': { background: 'teal' },
    'three of each kind, where places for a fourth are empty': {
      camera: { position: [0, 2, 9] },
      lights: [lamp, sun],
      objects: [
        { type: 'disc', radius: 0.5 },
        { type: 'quad' },
        { type: 'box', size: [0.6, 0.7, 0.8] },
        { type: 'cylinder', radius: 0.3 },
        { type: 'cone', radius: 0.4 },
        { type: 'torus', radius: 0.5, tube: 0.2 },
        { type: 'triangle' },
      ].flatMap((shape, row) => [-1, 0, 1].map((column) => placed(shape, [1.2 * column, 0.8 * row - 2.4, -row]))),
    },
    'more objects and lights than are written out one by one': {
      camera: { position: [0, 3, 9] },
      lights: Array.from({ length: 9 }, (_, i) => ({
        ...lamp,
        position: [i - 4, 4, 3],
        intensity: 10,
        color: [1, 1 - i / 10, 0.5],
      })),
      environment: { color: [0.1, 0.1, 0.2] },
      objects: [
        floor,
        ...Array.from({ length: 12 }, (_, i) => ({
          ...ball,
          center: [3 * Math.cos(i), -0.5 + i / 8, 3 * Math.sin(i)],
          radius: 0.5,
          metalness: i % 2,
          roughness: i / 12,
        })),
      ],
    },
    'many objects seen from inside one of them': {
      camera: { position: [0, 0, 0], target: [0, 0, -1] },
      lights: [{ ...lamp, position: [1, 1, 1] }],
      objects: [
        { ...ball, radius: 8 },
        ...Array.from({ length: 10 }, (_, i) => ({ ...ball, center: [i - 5, Math.sin(i), -4], radius: 0.4 })),
      ],
    },
  };

  for (const [what, scene] of Object.entries(scenes)) it(`draws ${what} alike`, () => agree(what, parseScene(scene)));
});
