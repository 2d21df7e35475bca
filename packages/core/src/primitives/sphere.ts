import { number, vector } from '../fields.ts';
import { toFrame } from '../frame.ts';
import { length, subtract, type Vec3 } from '../vector.ts';
import { definePrimitive } from './primitive.ts';

/** For most scenes; see `any-sphere.ts` for the others. */
export const sphere = definePrimitive({
  doc: 'A ball. U is the arc from the meridian of +z towards +x, V that from the pole at +y downwards.',
  fields: {
    center: vector('Centre.', { default: [0, 0, 0] }),
    radius: number('Radius.', { default: 1, above: 0 }),
  },
  record: [
    { name: 'center', type: 'vec3' },
    { name: 'radius2', type: 'float' },
    { name: 'curvature', type: 'float' },
    { name: 'power', type: 'float' },
  ],
  pack({ center, radius }, frame, { side }) {
    const c = toFrame(frame, center);
    const r = radius * frame.scale;
    const distance = length(c);
    return {
      center: c,
      radius2: r * r,
      // Times the way to the centre, the normal that shading needs: inwards where the camera and so all paths are inside.
      curvature: -side / r,
      // The camera's power, |c|² - r², as a product: nothing large cancels next to a planet's surface.
      power: (distance - r) * (distance + r),
    };
  },
  closed: true,
  bounds: ({ center, radius }) => ({
    min: center.map((x) => x - radius) as unknown as Vec3,
    max: center.map((x) => x + radius) as unknown as Vec3,
  }),
  extent: ({ center, radius }, frame) => Math.max(length(toFrame(frame, center)), radius * frame.scale),
  size: ({ radius }) => radius,
  clearance: ({ center, radius }, point) => Math.abs(length(subtract(point, center)) - radius),
  side: ({ center, radius }, point) => (length(subtract(point, center)) < radius ? -1 : 1),
  farSide: () => 1,
  occludes: (side) => side > 0,
});
