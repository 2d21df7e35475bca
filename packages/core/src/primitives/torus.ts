import { number, vector } from '../fields.ts';

/** What an author may say of a torus. */
export const torusTable = {
  doc:
    'A ring with a round tube. U is the arc around the axis on the centre line of the tube, counter-clockwise as seen ' +
    'from the tip of the axis, from the direction that a plane with the axis as its normal has as its tangent; ' +
    'V is the arc around the tube from its outermost circle, first in the direction of the axis.',
  fields: {
    center: vector('Centre.', { default: [0, 0, 0] }),
    axis: vector('The direction around which it is round.', { default: [0, 1, 0], nonzero: true }),
    radius: number('Radius of the centre line of the tube.', { default: 1, above: 0 }),
    tube: number('Radius of the tube, below that of the ring.', { default: 0.25, above: 0 }),
  },
} as const;
