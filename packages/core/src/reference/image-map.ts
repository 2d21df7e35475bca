/** Twin of shaders/image-map.glsl: images on surfaces, and where on them a point is. */
import type { EnvironmentImage } from '../environment-image.ts';
import { imageOn, unitPoint } from '../image-map.ts';
import type { ShapeKind } from '../primitives/index.ts';
import type { ResolvedScene } from '../resolve-scene.ts';
import { multiply, type Vec3 } from '../vector.ts';

interface ImagePlace {
  readonly uv: readonly [number, number];
  /** Whether the image goes on at its other edge. */
  readonly around: readonly [boolean, boolean];
}

const fraction = (x: number): number => x - Math.floor(x);

/** The angle of a point as a part of a full turn, from 0 to 1. */
const turnOf = (y: number, x: number): number => fraction(Math.atan2(y, x) / (2 * Math.PI));

const within = (uv: readonly [number, number]): ImagePlace => ({ uv, around: [false, false] });

/** The square around the unit disc. */
const onDisc = ([x, y]: Vec3): ImagePlace => within([0.5 * x + 0.5, 0.5 * y + 0.5]);

const onSide = ([x, y, z]: Vec3): ImagePlace => ({ uv: [turnOf(y, x), z], around: [true, false] });

/** By kind, where a point of the unit form is on an image. */
const places: { readonly [K in ShapeKind]: (q: Vec3) => ImagePlace } = {
  sphere: ([x, y, z]) => ({
    uv: [turnOf(x, z), 1 - Math.atan2(Math.hypot(x, z), y) / Math.PI],
    around: [true, false],
  }),
  plane: ([x, y]) => ({ uv: [fraction(x), fraction(y)], around: [true, true] }),
  disc: onDisc,
  quad: ([x, y]) => within([x, y]),
  triangle: ([x, y]) => within([x, y]),
  box([x, y, z]) {
    const [a, b, c] = [Math.abs(x - 0.5), Math.abs(y - 0.5), Math.abs(z - 0.5)];
    if (a >= Math.max(b, c)) return within([z, y]);
    return within(b >= c ? [x, z] : [x, y]);
  },
  cylinder: (q) => (Math.abs(2 * q[2] - 1) > Math.hypot(q[0], q[1]) ? onDisc(q) : onSide(q)),
  cone: (q) => (-q[2] > Math.hypot(q[0], q[1]) + q[2] - 1 ? onDisc(q) : onSide(q)),
  torus: ([x, y, z]) => ({ uv: [turnOf(y, x), turnOf(z, Math.hypot(x, y) - 1)], around: [true, true] }),
};

/** The colour of an object at a point, times that of the image on it. */
export function mapped(scene: ResolvedScene, object: number, point: Vec3, color: Vec3): Vec3 {
  const { shape, material } = scene.objects[object] as ResolvedScene['objects'][number];
  const image = imageOn(scene, material);
  if (!image) return color;
  const q = unitPoint(shape, scene.materials[material]?.checkerSize ?? 1, point);
  return multiply(color, imageAt(image, places[shape.type](q)));
}

/** Linear between the centres of texels. */
function imageAt({ width, height, data }: EnvironmentImage, { uv: [u, v], around }: ImagePlace): Vec3 {
  const clamped = (x: number): number => Math.min(Math.max(x, 0), 1);
  const [x, y] = [clamped(u) * width - 0.5, clamped(1 - v) * height - 0.5];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const texel = (column: number, row: number, channel: number): number => {
    const at = withinImage(row, height, around[1]) * width + withinImage(column, width, around[0]);
    return data[3 * at + channel] as number;
  };
  const mix = (a: number, b: number, part: number): number => a + (b - a) * part;
  return [0, 1, 2].map((c) =>
    mix(mix(texel(i, j, c), texel(i + 1, j, c), x - i), mix(texel(i, j + 1, c), texel(i + 1, j + 1, c), x - i), y - j),
  ) as unknown as Vec3;
}

/** A number of a row or column within 0 to size - 1. */
function withinImage(i: number, size: number, around: boolean): number {
  return around ? (i + size) % size : Math.min(Math.max(i, 0), size - 1);
}
