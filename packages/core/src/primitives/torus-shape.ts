import { powerOfTwoBelow, toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { addScaled, dot, length, normalize, scale, subtract, type Vec3 } from '../vector.ts';
import { planeAxes } from './plane.ts';
import { definePrimitive } from './primitive.ts';
import { torusTable } from './torus.ts';

export const torus = definePrimitive({
  ...torusTable,
  record: [
    { name: 'center', type: 'vec3' },
    { name: 'unit', type: 'float' },
    { name: 'axis', type: 'vec3' },
    { name: 'radius', type: 'float' },
    { name: 'tube', type: 'float' },
    { name: 'squares', type: 'float' },
    { name: 'power', type: 'float', when: 'wideRange' },
    { name: 'away', type: 'float', when: 'wideRange' },
    { name: 'out1', type: 'vec3', when: 'wideRange' },
    { name: 'out2', type: 'vec3', when: 'wideRange' },
    { name: 'out3', type: 'vec3', when: 'wideRange' },
    { name: 'cellsU', type: 'float', when: 'torusChecker' },
    { name: 'tangent', type: 'vec3', when: 'torusChecker' },
    { name: 'cellsV', type: 'float', when: 'torusChecker' },
  ],
  pack({ center, axis, radius, tube }, frame, { checkerSize }) {
    // In units that make the ring's radius 1/4 to 1/2: no fourth power of it leaves the range of f32.
    const unit = ringUnit(radius);
    const ring = radius * unit;
    const thick = tube * unit;
    const { normal, tangent } = planeAxes({ normal: axis });
    const fromRing = awayFromRing({ center, axis, radius }, frame.origin);
    const away = length(fromRing) * unit;
    const parts = splitParts(normalize(fromRing));
    return {
      center: toFrame(frame, center),
      // Ring units in one unit of the frame.
      unit: unit / frame.scale,
      axis: normal,
      radius: ring,
      tube: thick,
      squares: (ring - thick) * (ring + thick),
      // The camera's: the square of its distance to the centre line less the tube's, that distance, and the direction
      // away from the line, which must not cancel where a huge ring is near.
      power: (away - thick) * (away + thick),
      away,
      out1: parts[0],
      out2: parts[1],
      out3: parts[2],
      // Cells along one radian.
      cellsU: radius / checkerSize,
      tangent,
      cellsV: tube / checkerSize,
    };
  },
  closed: true,
  bounds: (shape) => {
    const { normal } = planeAxes({ normal: shape.axis });
    const reach = normal.map((x) => shape.radius * Math.sqrt(Math.max(1 - x * x, 0)) + shape.tube);
    return {
      min: subtract(shape.center, reach as unknown as Vec3),
      max: addScaled(shape.center, reach as unknown as Vec3, 1),
    };
  },
  extent: ({ center, radius, tube }, frame) => Math.max(length(toFrame(frame, center)), (radius + tube) * frame.scale),
  size: ({ tube }) => tube,
  clearance: (shape, point) => Math.abs(length(awayFromRing(shape, point)) - shape.tube),
  side: (shape, point) => (length(awayFromRing(shape, point)) < shape.tube ? -1 : 1),
  farSide: () => 1,
  // It is hollow from inside and bent from outside.
  occludes: () => true,
});

/** A power of two that makes lengths of about a ring's radius 1/4 to 1/2. */
export const ringUnit = (radius: number): number => 1 / (4 * powerOfTwoBelow(radius));

/** The way to a point from the nearest point of the ring's centre line. */
export function awayFromRing(
  { center, axis, radius }: { readonly center: Vec3; readonly axis: Vec3; readonly radius: number },
  point: Vec3,
): Vec3 {
  const { normal, tangent } = planeAxes({ normal: axis });
  const x = subtract(point, center);
  const height = dot(x, normal);
  const level = addScaled(x, normal, -height);
  const fromAxis = length(level);
  // On the axis, all directions are alike.
  const outwards = fromAxis > 0 ? scale(level, 1 / fromAxis) : tangent;
  return addScaled(scale(normal, height), outwards, fromAxis - radius);
}
