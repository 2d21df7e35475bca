/** The stress set: scenes in which f32 by the textbook goes wrong. Lengths are in metres where a scene is of this world. */
import { eclipse } from './eclipse.ts';
import { scaleScene } from './scale-scene.ts';

type Json = { readonly [key: string]: unknown };

const sphere = (center: readonly number[], radius: number, rest: Json = {}): Json => ({
  type: 'sphere',
  center,
  radius,
  ...rest,
});

const sun = { type: 'directional', direction: [-2, -2, -1], intensity: 3 };
const lamp = { type: 'point', position: [2, 3, 4], intensity: 60 };
const sky = { top: '#6ea8e8', bottom: '#c9b79a' };
const rainbow = (n: number): string => `hsl(${(137 * n) % 360} 70% 50%)`;

/** A few shapes on a floor, to be made large and small. */
const still: Json = {
  camera: { position: [1, 2, 6], target: [0, 0.5, 0] },
  lights: [lamp, sun],
  environment: sky,
  objects: [
    { type: 'plane', color: '#ccc' },
    sphere([-1.2, 0.7, 0], 0.7, { material: 'gold' }),
    { type: 'box', center: [0.3, 0.4, 0.2], size: [0.8, 0.8, 0.8], color: 'seagreen' },
    { type: 'torus', center: [1.4, 0.5, 0.6], axis: [0, 1, 2], radius: 0.4, tube: 0.1, color: 'crimson' },
    { type: 'cone', base: [0.2, 0, -1.3], tip: [0.2, 1.6, -1.3], radius: 0.6, color: 'orange' },
  ],
};

const planet = sphere([0, -6371000, 0], 6371000, { color: '#8a9a6b', roughness: 1, specular: 0 });

const shells = (count: number): readonly Json[] =>
  Array.from({ length: count }, (_, i) => sphere([0, 0, 0], 1 - i * 1e-6, { color: rainbow(i), roughness: 0.3 }));

/** From 10 million units away, through a lens that shows 4 units. */
const fromAfar = (direction: readonly number[], objects: readonly Json[]): Json => ({
  ...still,
  camera: { position: direction.map((x) => x * 1e7), target: [0, 0.5, 0], fov: (2 * Math.atan(2e-7) * 180) / Math.PI },
  objects,
});

/** By name. */
export const extremes: { readonly [name: string]: Json } = {
  'a ball and its shadow on a planet': {
    camera: { position: [0, 1.7, 4], target: [0, 0.8, 0] },
    environment: sky,
    lights: [sun],
    objects: [planet, sphere([0, 0.5, 0], 0.5, { color: 'crimson', roughness: 0.2 })],
  },
  'a ball and its shadow on a planet 8e12 times as large': {
    camera: { position: [0, 1.7, 4], target: [0, 0.8, 0] },
    environment: sky,
    lights: [sun],
    objects: [
      sphere([0, -4e12, 0], 4e12, { roughness: 1, specular: 0 }),
      sphere([0, 0.5, 0], 0.5, { color: 'crimson' }),
    ],
  },
  'things of every kind on a planet': {
    ...still,
    lights: [sun],
    objects: [planet, ...(still.objects as readonly Json[]).slice(1)],
  },
  'a solar eclipse at true scale': eclipse.scene,
  'shells a millionth apart, from outside': {
    camera: { position: [0.5, 1, 4] },
    lights: [lamp, sun],
    environment: sky,
    objects: shells(5),
  },
  'shells a millionth apart, from within': {
    camera: { position: [0.2, 0.1, 0.3], target: [0, 0, -1], fov: 90 },
    lights: [{ ...lamp, position: [0.3, 0.4, -0.2], intensity: 3 }],
    objects: shells(5),
  },
  'between two shells a millionth apart': {
    camera: { position: [0, 1 - 5e-7, 0], target: [1, 1, 0], fov: 60 },
    lights: [{ ...lamp, position: [1e-6, 1 - 4e-7, 0], intensity: 1e-12 }],
    environment: { color: 'white' },
    objects: shells(2),
  },
  'two spheres that touch in a point': {
    camera: { position: [0, 0.6, 1.5], target: [0, 0, 0], fov: 40 },
    lights: [lamp, sun],
    environment: sky,
    objects: [sphere([-1, 0, 0], 1, { color: 'crimson' }), sphere([1, 0, 0], 1, { material: 'gold' })],
  },
  'nanometres, in metres': scaleScene(still, 1e-9),
  'light-years, in metres': scaleScene(still, 9.4607304725808e15),
  'a camera in a plane': {
    ...still,
    camera: { position: [1, 0, 6], target: [0, 0, 0] },
  },
  'a camera in a tilted plane': {
    ...still,
    camera: { position: [1, 2, 6], target: [0, 0.5, 0] },
    objects: [...(still.objects as readonly Json[]), { type: 'plane', point: [1, 2, 6], normal: [1, 2, 0.5] }],
  },
  'a narrow lens 10 million units away': fromAfar([0.2, 0.35, 1], (still.objects as readonly Json[]).slice(1)),
  'a narrow lens 10 million units above a floor': fromAfar([0.2, 0.35, 1], still.objects as readonly Json[]),
  'a narrow lens 10 million units away, two balls': fromAfar(
    [0, 0.1, 1],
    [sphere([-0.7, 0.5, 0], 0.8, { color: 'crimson' }), sphere([0.8, 0.5, 0.3], 0.7, { material: 'silver' })],
  ),
  'a light inside a ball, from outside': {
    camera: { position: [0, 1, 5] },
    lights: [{ ...lamp, position: [0.2, 0, 0.1], intensity: 5 }],
    background: 'navy',
    objects: [sphere([0, 0, 0], 1), { type: 'plane', point: [0, -1, 0] }],
  },
  'a light inside a ball, from inside': {
    camera: { position: [0, 0.2, 0.9], target: [0, 0, 0], fov: 80 },
    lights: [{ ...lamp, position: [0.2, 0, 0.1], intensity: 5 }],
    objects: [sphere([0, 0, 0], 1, { metalness: 0.6, roughness: 0.3 }), sphere([-0.4, 0, -0.3], 0.2)],
  },
  'light that grazes a plane to the horizon': {
    camera: { position: [0, 1.7, 6], target: [0, 1.2, 0], fov: 40 },
    lights: [{ type: 'directional', direction: [1, -1e-4, -2], intensity: 2000 }],
    objects: [
      { type: 'plane', color: '#ddd', checker: '#999', checkerSize: 2 },
      sphere([-0.5, 0.5, 0], 0.5, { color: 'crimson' }),
      { type: 'quad', corner: [0.3, 0, -1], edgeU: [0.6, 0, 0], edgeV: [0, 0.8, 0], color: 'seagreen' },
    ],
  },
  'roughness from 0 to a ten-thousandth': {
    camera: { position: [0, 1.5, 6] },
    lights: [lamp],
    environment: sky,
    objects: [0, 1e-9, 1e-7, 1e-6, 1e-5, 3e-5, 1e-4].map((roughness, i) =>
      sphere([0.9 * i - 2.7, 0, 0], 0.4, { roughness, metalness: i % 2, color: rainbow(i) }),
    ),
  },
  'a hundred coincident spheres': {
    camera: { position: [0.5, 1, 4] },
    lights: [lamp, sun],
    objects: Array.from({ length: 100 }, (_, i) => sphere([0.1, 0.2, 0.3], 1.1, { color: rainbow(i) })),
  },
  'a hundred coincident planes': {
    camera: { position: [0.5, 1, 4] },
    lights: [lamp, sun],
    objects: Array.from({ length: 100 }, (_, i) => ({ type: 'plane', point: [0, -0.3, 0], color: rainbow(i) })),
  },
  'coincident shapes of each kind, twenty times': {
    ...still,
    objects: Array.from({ length: 20 }, (_, i) =>
      (still.objects as readonly Json[]).map((object) => ({ ...object, color: rainbow(i), metalness: 0 })),
    ).flat(),
  },
  'shapes of each kind in stretched groups, twenty times': {
    ...still,
    objects: Array.from({ length: 20 }, (_, i) => ({
      type: 'group',
      rotation: [0, 20, 0],
      scale: [1, 1.25, 0.75],
      objects: (still.objects as readonly Json[]).map((object) => ({ ...object, color: rainbow(i) })),
    })),
  },
  'a camera in a disc and a face of a box': {
    ...still,
    objects: [
      ...(still.objects as readonly Json[]),
      { type: 'disc', center: [1.5, 2, 6], normal: [0, 1, 0], radius: 2 },
      { type: 'box', center: [1, 1.5, 6.5], size: [1, 1, 1] },
    ],
  },
};
