import { toFrame } from '../frame.ts';
import { dot, length, subtract, type Vec3 } from '../vector.ts';
import { discTable } from './disc.ts';
import { cellMembers, lowWord, normalMembers, packCells, packNormal } from './flat.ts';
import { planeAxes } from './plane.ts';
import { definePrimitive } from './primitive.ts';

export const disc = definePrimitive({
  ...discTable,
  record: [
    { name: 'center', type: 'vec3' },
    { name: 'centerLow', type: 'vec3', when: 'wideRange' },
    ...normalMembers,
    { name: 'height', type: 'float' },
    { name: 'radius2', type: 'float' },
    ...cellMembers('disc'),
  ],
  pack(shape, frame, { checkerSize, wideRange }) {
    const { normal, tangent, bitangent } = planeAxes(shape);
    const center = toFrame(frame, shape.center);
    return {
      center,
      centerLow: lowWord(center),
      ...packNormal(normal, wideRange),
      // From the camera to the plane, along the normal.
      height: dot(normal, center),
      radius2: (shape.radius * frame.scale) ** 2,
      ...packCells(frame, shape.center, tangent, bitangent, checkerSize),
    };
  },
  closed: false,
  bounds(shape) {
    const { normal } = planeAxes(shape);
    const reach = normal.map((x) => shape.radius * Math.sqrt(Math.max(0, 1 - x * x)));
    return {
      min: shape.center.map((x, i) => x - (reach[i] as number)) as unknown as Vec3,
      max: shape.center.map((x, i) => x + (reach[i] as number)) as unknown as Vec3,
    };
  },
  extent: ({ center, radius }, frame) => Math.max(length(toFrame(frame, center)), radius * frame.scale),
  size: ({ radius }) => radius,
  clearance(shape, point) {
    const away = subtract(point, shape.center);
    const height = Math.abs(dot(planeAxes(shape).normal, away));
    return length(away) <= shape.radius ? height : Math.max(height, length(away) - shape.radius);
  },
  side: () => 1,
  farSide: () => 1,
  occludes: () => true,
});
