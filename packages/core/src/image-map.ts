/**
 * Images on surfaces: how a point of each shape is brought to the unit form of its kind, where its place on an image is
 * easily told (see shaders/image-map.glsl), and how images are laid out for the shader.
 */
import type { Matrix } from './affine.ts';
import type { EnvironmentImage } from './environment-image.ts';
import type { PlacedShape } from './flat-scene.ts';
import type { Frame } from './frame.ts';
import { boxCorners } from './primitives/box-shape.ts';
import { roundAxes } from './primitives/cylinder-shape.ts';
import { duals } from './primitives/flat.ts';
import { type ShapeKind, shapeKinds } from './primitives/index.ts';
import { planeAxes } from './primitives/plane.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import type { Shape } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { addScaled, dot, length, scale, subtract, type Vec3 } from './vector.ts';

export const imageMapRecord = [
  { name: 'mapX', type: 'vec4', when: 'map' },
  { name: 'mapY', type: 'vec4', when: 'map' },
  { name: 'mapZ', type: 'vec4', when: 'map' },
  { name: 'image', type: 'vec3', when: 'map' },
] as const;

/** A point X of the scene is at rows · (X - start) in the unit form. */
interface UnitForm {
  readonly rows: Matrix;
  readonly start: Vec3;
}

const NONE: Vec3 = [0, 0, 0];

const along = (rows: readonly Vec3[], start: Vec3): UnitForm => ({
  rows: [rows[0] ?? NONE, rows[1] ?? NONE, rows[2] ?? NONE],
  start,
});

/** A cylinder or a cone: radius 1, height 1. */
function uprightForm(base: Vec3, top: Vec3, radius: number): UnitForm {
  const { axis, tangent, bitangent } = roundAxes(base, top);
  const height = length(subtract(top, base));
  return along([scale(tangent, 1 / radius), scale(bitangent, 1 / radius), scale(axis, 1 / height)], base);
}

function axisForm(factors: Vec3, start: Vec3): UnitForm {
  return along(
    [
      [factors[0], 0, 0],
      [0, factors[1], 0],
      [0, 0, factors[2]],
    ],
    start,
  );
}

/** The ball of radius 1; squares and edges of length 1; the disc of radius 1; a ring of radius 1. `tile`: on planes. */
const unitForms: { readonly [K in ShapeKind]: (shape: Shape<K>, tile: number) => UnitForm } = {
  sphere: ({ center, radius }) => axisForm([1 / radius, 1 / radius, 1 / radius], center),
  plane(shape, tile) {
    const { tangent, bitangent } = planeAxes(shape);
    return along([scale(tangent, 1 / tile), scale(bitangent, 1 / tile)], shape.point);
  },
  disc(shape) {
    const { tangent, bitangent } = planeAxes(shape);
    return along([scale(tangent, 1 / shape.radius), scale(bitangent, 1 / shape.radius)], shape.center);
  },
  quad: ({ corner, edgeU, edgeV }) => along(duals(edgeU, edgeV), corner),
  box: (shape) => axisForm(shape.size.map((side) => 1 / side) as unknown as Vec3, boxCorners(shape).min),
  cylinder: ({ base, top, radius }) => uprightForm(base, top, radius),
  cone: ({ base, tip, radius }) => uprightForm(base, tip, radius),
  torus({ center, axis, radius }) {
    const { normal, tangent, bitangent } = planeAxes({ normal: axis });
    return along(
      [tangent, bitangent, normal].map((row) => scale(row, 1 / radius)),
      center,
    );
  },
  triangle: ({ a, b, c }) => along(duals(subtract(b, a), subtract(c, a)), a),
};

/** Of a shape in a space of its own, from the scene all the same. */
export function unitPoint(shape: PlacedShape, tile: number, point: Vec3): Vec3 {
  const { rows, start } = (unitForms[shape.type] as (one: PlacedShape, tile: number) => UnitForm)(shape, tile);
  const away = subtract(shape.place ? shape.place.pointBack(point) : point, start);
  return [dot(rows[0], away), dot(rows[1], away), dot(rows[2], away)];
}

/** The directions of the scene along which the coordinates of the unit form grow. */
function unitRows(shape: PlacedShape, tile: number): Matrix {
  const { rows } = (unitForms[shape.type] as (one: PlacedShape, tile: number) => UnitForm)(shape, tile);
  const { place } = shape;
  if (!place) return rows;
  const [x, y, z] = place.inverse;
  const back = (row: Vec3): Vec3 => addScaled(addScaled(scale(x, row[0]), y, row[1]), z, row[2]);
  return [back(rows[0]), back(rows[1]), back(rows[2])];
}

/** The image on an object, if there is one and it was handed in. */
export function imageOn({ materials, images }: ResolvedScene, material: number): EnvironmentImage | undefined {
  const { map } = materials[material] ?? {};
  return map === undefined ? undefined : images?.get(map);
}

/** The kinds of shapes that have images on them. */
export const mappedKinds = (scene: ResolvedScene): readonly ShapeKind[] =>
  shapeKinds.filter((kind) =>
    scene.objects.some(({ shape, material }) => shape.type === kind && imageOn(scene, material)),
  );

/** What the shader is told of the image on the object that has this material. Each such object has its own. */
export function packImageMap(scene: ResolvedScene, index: number, frame: Frame): RecordValues<typeof imageMapRecord> {
  const image = imageOn(scene, index);
  const shape = scene.objects.find(({ material }) => material === index)?.shape;
  if (!image || !shape) return { mapX: ZERO, mapY: ZERO, mapZ: ZERO, image: NONE };
  const tile = scene.materials[index]?.checkerSize ?? 1;
  const rows = unitRows(shape, tile);
  const camera = unitPoint(shape, tile, frame.origin);
  // An image on a plane is repeated: whole ones between the camera and the plane's point need not be counted.
  const offset = shape.type === 'plane' ? camera.map((x) => x - Math.round(x)) : camera;
  const [mapX, mapY, mapZ] = rows.map((row, i) => [...scale(row, 1 / frame.scale), offset[i] as number]);
  const { places } = imageAtlas(scene);
  return { mapX, mapY, mapZ, image: [places.get(image) ?? 0, image.width, image.height] } as RecordValues<
    typeof imageMapRecord
  >;
}

const ZERO = [0, 0, 0, 0] as const;

/** Texels in a row of the texture that holds all images, one after the other. */
export const IMAGE_ROW = 2048;

export interface ImageAtlas {
  /** Of each image, the number of its first texel. */
  readonly places: ReadonlyMap<EnvironmentImage, number>;
  /** How many texels all of them have. */
  readonly texels: number;
}

/** How the images on the surfaces of a scene are laid out. */
export function imageAtlas(scene: ResolvedScene): ImageAtlas {
  const places = new Map<EnvironmentImage, number>();
  let texels = 0;
  for (const index of scene.materials.keys()) {
    const image = imageOn(scene, index);
    if (!image || places.has(image)) continue;
    places.set(image, texels);
    texels += image.width * image.height;
  }
  return { places, texels };
}
