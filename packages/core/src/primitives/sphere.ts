import { number, vector } from '../fields.ts';
import { toFrame } from '../frame.ts';
import { splitParts } from '../split-parts.ts';
import { length, scale, subtract, type Vec3 } from '../vector.ts';
import { lowWord } from './flat.ts';
import { definePrimitive } from './primitive.ts';

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
    { name: 'cells', type: 'float', when: 'sphereChecker' },
    { name: 'centerLow', type: 'vec3', when: 'wideRange' },
    { name: 'half1', type: 'vec3', when: 'wideRange' },
    { name: 'half2', type: 'vec3', when: 'wideRange' },
    { name: 'half3', type: 'vec3', when: 'wideRange' },
  ],
  pack({ center, radius }, frame, { side, checkerSize }) {
    const c = toFrame(frame, center);
    const r = radius * frame.scale;
    const distance = length(c);
    // The frame has lengths below 2, and `splitParts` takes those up to 1.
    const [half1, half2, half3] = splitParts(scale(c, 0.5));
    return {
      center: c,
      radius2: r * r,
      // Times the way to the centre, the normal that shading needs: inwards where the camera and so all paths are inside.
      curvature: -side / r,
      // The camera's power, |c|² - r², as a product: nothing large cancels next to a planet's surface.
      power: (distance - r) * (distance + r),
      // Cells along one radian.
      cells: radius / checkerSize,
      // What f32 leaves of the centre.
      centerLow: lowWord(c),
      half1,
      half2,
      half3,
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
