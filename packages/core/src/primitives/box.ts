import { vector } from '../fields.ts';

/** What an author may say of a box. */
export const boxTable = {
  doc: 'A box along the axes. (U, V) from its lowest corner: (z, y) on the faces to ±x, (x, z) on ±y, (x, y) on ±z.',
  fields: {
    center: vector('Centre.', { default: [0, 0, 0] }),
    size: vector('Lengths of its edges along x, y and z.', { default: [1, 1, 1], positive: true }),
  },
} as const;
