import { number, vector } from '../fields.ts';
import { toFrame } from '../frame.ts';
import { length, type Vec3 } from '../vector.ts';
import { definePrimitive } from './primitive.ts';

export const sphere = definePrimitive({
  doc: 'A ball.',
  fields: {
    center: vector('Centre.', { default: [0, 0, 0] }),
    radius: number('Radius.', { default: 1, above: 0 }),
  },
  record: [
    { name: 'center', type: 'vec3' },
    { name: 'radius', type: 'float' },
    { name: 'power', type: 'float' },
    { name: 'material', type: 'int' },
  ],
  pack({ center, radius }, frame) {
    const c = toFrame(frame, center);
    const r = radius * frame.scale;
    const distance = length(c);
    // The power of the camera point, |c|² - r², as a product: nothing large cancels next to a planet's surface.
    return { center: c, radius: r, power: (distance - r) * (distance + r), material: 0 };
  },
  bounds: ({ center, radius }) => ({
    min: center.map((x) => x - radius) as unknown as Vec3,
    max: center.map((x) => x + radius) as unknown as Vec3,
  }),
  extent: ({ center, radius }, frame) => Math.max(length(toFrame(frame, center)), radius * frame.scale),
  shadowsItself: 'inside',
});
