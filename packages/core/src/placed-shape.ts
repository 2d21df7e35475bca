/**
 * Shapes that stay in a space of their own: a ray is mapped into that space, by the inverse of the map out of it. Both
 * spaces are packed relative to the camera, each in its own power of two, so that the map between them has no offset.
 */
import type { Affine } from './affine.ts';
import type { Fields } from './fields.ts';
import { type Frame, powerOfTwoBelow, toFrame } from './frame.ts';
import { primitiveOfKind } from './parts.ts';
import type { ShapeKind } from './primitives/index.ts';
import type { Primitive } from './primitives/primitive.ts';
import type { Shape } from './schema.ts';
import { splitParts } from './split-parts.ts';
import type { Member, RecordValues } from './std140.ts';
import { length, scale, type Vec3 } from './vector.ts';

type AnyPrimitive = Primitive<Fields, readonly Member[]>;

/** A primitive as it is in the scene, where a map takes it to: what is packed of it is in its own space. */
export function placedPrimitive(own: AnyPrimitive, place: Affine): AnyPrimitive {
  const longest = Math.max(...place.inverse.map(length));
  return {
    ...own,
    pack: (shape, frame, context) => own.pack(shape, ownFrame(own, shape, place, frame.origin), context),
    bounds(shape) {
      const box = own.bounds(shape);
      return box && place.bounds(box);
    },
    extent(shape, frame) {
      const box = own.bounds(shape);
      // A plane, which has no end, is as far as the point that it is said to go through.
      const points = box ? place.corners(box) : [place.point((shape as Shape<'plane'>).point)];
      return Math.max(...points.map((point) => length(toFrame(frame, point))));
    },
    // No less than these may be left of a length.
    size: (shape) => own.size(shape) / longest,
    clearance: (shape, point) => own.clearance(shape, place.pointBack(point)) / longest,
    side: (shape, point) => own.side(shape, place.pointBack(point)),
    farSide: (shape, direction) => own.farSide(shape, place.directionBack(direction)),
  };
}

/** The space that a placed shape is packed in: its origin is the camera, its unit near the shape's largest length. */
function ownFrame(own: AnyPrimitive, shape: Parameters<AnyPrimitive['extent']>[0], place: Affine, camera: Vec3): Frame {
  const origin = place.pointBack(camera);
  const extent = own.extent(shape, { origin, scale: 1 });
  return { origin, scale: extent > 0 ? 1 / powerOfTwoBelow(extent) : 1 };
}

/** The rows of a map from the scene's frame to a shape's own, none longer than 1, and a factor on them. */
export const placementRecord = [
  { name: 'x', type: 'vec3' },
  { name: 'unit', type: 'float' },
  { name: 'y', type: 'vec3' },
  { name: 'z', type: 'vec3' },
  { name: 'x2', type: 'vec3', when: 'wideRange' },
  { name: 'x3', type: 'vec3', when: 'wideRange' },
  { name: 'y2', type: 'vec3', when: 'wideRange' },
  { name: 'y3', type: 'vec3', when: 'wideRange' },
  { name: 'z2', type: 'vec3', when: 'wideRange' },
  { name: 'z3', type: 'vec3', when: 'wideRange' },
] as const;

/** The map from the scene's frame to the shape's own; `wideRange`: its rows in three parts each. */
export function packPlacement(
  shape: Shape<ShapeKind>,
  place: Affine,
  frame: Frame,
  wideRange: boolean,
): RecordValues<typeof placementRecord> {
  const unit = 2 * powerOfTwoBelow(Math.max(...place.inverse.map(length)));
  const [x, y, z] = place.inverse.map((row) => splitRow(scale(row, 1 / unit), wideRange)) as [Parts, Parts, Parts];
  return {
    x: x[0],
    unit: (unit * ownFrame(primitiveOfKind(shape.type), shape, place, frame.origin).scale) / frame.scale,
    y: y[0],
    z: z[0],
    x2: x[1],
    x3: x[2],
    y2: y[1],
    y3: y[2],
    z2: z[1],
    z3: z[2],
  };
}

type Parts = readonly [Vec3, Vec3, Vec3];

const splitRow = (row: Vec3, wideRange: boolean): Parts => (wideRange ? splitParts(row) : [row, NONE, NONE]);

const NONE: Vec3 = [0, 0, 0];
