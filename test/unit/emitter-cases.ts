/** Emitters, and points to look at them from: for the tests of the reference, and of the shaders against it. */
import type { Vec3 } from '@ray-scene/core';
import { Affine } from '../../packages/core/src/affine.ts';
import { emitterTable } from '../../packages/core/src/emitter-table.ts';
import { type EmittingScene, sceneEmitters } from '../../packages/core/src/emitters.ts';
import type { EnvironmentImage } from '../../packages/core/src/environment-image.ts';
import { type Lighting, sampleEmitter } from '../../packages/core/src/reference/light/emitters.ts';

type Side = 'front' | 'back' | 'both';
type Shape = EmittingScene['objects'][number]['shape'];
type Light = EmittingScene['lights'][number];

const white: Vec3 = [1, 1, 1];

/** A scene of these lights, and of these shapes shining with radiance 1. */
export const emittingScene = (
  lights: readonly Light[],
  shapes: readonly object[],
  side: Side = 'both',
): EmittingScene => ({
  camera: { position: [0, 0, 0], target: [0, 0, -1] },
  lights,
  materials: [{ emission: white, emissionIntensity: 1, emissionSide: side }],
  objects: shapes.map((shape) => ({ shape: shape as Shape, material: 0 })),
});

/** Those emitters, and their table. */
export function lightingOf(scene: EmittingScene): Lighting {
  const emitters = sceneEmitters(scene);
  return { emitters, table: emitterTable(emitters) };
}

const pointLight = { color: white, intensity: 1, decay: 2, position: [0.5, 2, -1] } as const;

export const lights = {
  point: { ...pointLight, type: 'point' },
  'steady point': { ...pointLight, type: 'point', decay: 0 },
  spot: { ...pointLight, type: 'spot', target: [0, 0, 0.3], angle: 40, penumbra: 0.5 },
  'hard spot': { ...pointLight, type: 'spot', direction: [0, -1, 0], angle: 30, penumbra: 0 },
  directional: { type: 'directional', color: white, intensity: 2, direction: [1, -2, 0.5] },
  'the Sun': { type: 'directional', color: white, intensity: 2, direction: [1, -2, 0.5], angularDiameter: 0.53 },
  'a wide sun': { type: 'directional', color: white, intensity: 2, direction: [1, 2, 0.5], angularDiameter: 90 },
} as const satisfies { readonly [name: string]: Light };

const map = (position: Vec3, rotation: Vec3, factors: Vec3 = [1, 1, 1]): Affine =>
  Affine.identity.within({ position, rotation, scale: factors });

export const shapes = {
  sphere: { type: 'sphere', center: [0.2, 1, -2], radius: 0.7 },
  rectangle: { type: 'quad', corner: [-1, 1.5, -1.5], edgeU: [2, 0, 0], edgeV: [0, 0, 1.5] },
  'turned rectangle': { type: 'quad', corner: [-1, 1, -2], edgeU: [1.2, 0.9, 0], edgeV: [-0.6, 0.8, 0.5] },
  parallelogram: { type: 'quad', corner: [-1, 1, -2], edgeU: [2, 0, 0], edgeV: [0.7, 0.3, 1.5] },
  'small rectangle': { type: 'quad', corner: [1, 2, -2], edgeU: [0.1, 0, 0], edgeV: [0, 0, 0.2] },
  disc: { type: 'disc', center: [0.5, 1.5, -1], normal: [0.3, -1, 0.2], radius: 0.8 },
  triangle: { type: 'triangle', a: [-1, 1.5, -2], b: [1.5, 1.2, -1.5], c: [0, 2, 0.5] },
  box: { type: 'box', center: [0.3, 1.5, -1], size: [1, 0.6, 1.4] },
  cylinder: { type: 'cylinder', base: [-0.5, 1, -1.5], top: [0.7, 1.6, -1], radius: 0.4 },
  'turned box': { type: 'box', center: [0, 0, 0], size: [1, 0.6, 1.4], place: map([0.3, 1.5, -1], [20, 40, 10]) },
  ellipsoid: { type: 'sphere', center: [0.1, 0, 0], radius: 1, place: map([0.2, 1, -2], [10, 50, 0], [0.7, 0.4, 1]) },
  'elliptic cylinder': {
    type: 'cylinder',
    base: [0, -0.5, 0],
    top: [0, 0.5, 0],
    radius: 0.5,
    place: map([0.3, 1.3, -1.2], [30, 0, 40], [0.5, 1, 1.2]),
  },
  'elliptic disc': {
    type: 'disc',
    center: [0, 0, 0],
    normal: [0.3, -1, 0.2],
    radius: 1,
    place: map([0.5, 1.5, -1], [0, 20, 0], [1, 0.8, -0.4]),
  },
} as const;

/** From all around them. */
export const outside: readonly Vec3[] = [
  [0, 0, 0],
  [0.3, 0.2, -1],
  [4, 1.4, -1.2],
  [0.4, 5, -1.3],
  [-1.5, 0.7, -3],
];

/** Points in the solid ones. */
export const inside: { readonly [name: string]: Vec3 } = {
  sphere: [0.3, 1.2, -1.9],
  box: [0.1, 1.6, -0.5],
  cylinder: [0.2, 1.25, -1.2],
  'turned box': [0.4, 1.6, -0.8],
  ellipsoid: [0.3, 1.1, -1.8],
  'elliptic cylinder': [0.35, 1.4, -1.2],
};

/** Numbers of a fixed generator, uniform in [0, 1) with 24 bits. */
export function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x9e3779b9) | 0;
    let x = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    x = Math.imul(x ^ (x >>> 15), 0x735a2d97);
    return ((x ^ (x >>> 15)) >>> 8) * 2 ** -24;
  };
}

/** The mean over n samples of what `value` says of them, and its standard error; no sample counts as 0. */
export function average(
  lighting: Lighting,
  p: Vec3,
  value: (sample: NonNullable<ReturnType<typeof sampleEmitter>>) => number,
  { n = 20_000, seed = 1, own }: { n?: number; seed?: number; own?: number } = {},
): { readonly mean: number; readonly error: number } {
  const next = numbers(seed);
  let [sum, squares] = [0, 0];
  for (let i = 0; i < n; i++) {
    const sample = sampleEmitter(lighting, p, next(), [next(), next()], own);
    const x = sample ? value(sample) : 0;
    sum += x;
    squares += x * x;
  }
  const mean = sum / n;
  return { mean, error: Math.sqrt(Math.max(squares / n - mean * mean, 0) / n) };
}

/** A sky with a sun of one texel in it, dark below but for a few texels. */
export function sky(width: number, height: number): EnvironmentImage {
  const next = numbers(31);
  const data = Float32Array.from({ length: 3 * width * height }, (_, i) => {
    const texel = Math.floor(i / 3);
    const row = Math.floor(texel / width);
    if (row === 2 && texel % width === 5) return 3000;
    return row < height / 2 ? 0.2 + next() : next() > 0.99 ? 3 : 0;
  });
  return { width, height, data };
}

/** A scene in which nothing but an image shines. */
export const surroundedBy = (image: EnvironmentImage, intensity = 1, rotation = 0): EmittingScene => ({
  ...emittingScene([], []),
  environment: { kind: 'image', image, intensity, rotation },
});
