import { vector } from '../fields.ts';

/** What an author may say of a quad. */
export const quadTable = {
  doc: 'A parallelogram; its front is where edge U × edge V points to. U and V run along its edges, from the corner.',
  fields: {
    corner: vector('One of its corners.', { default: [-0.5, 0, 0.5] }),
    edgeU: vector('From the corner to the next one.', { default: [1, 0, 0], nonzero: true, edge: true }),
    edgeV: vector('From the corner to the other one beside it.', { default: [0, 0, -1], nonzero: true, edge: true }),
  },
} as const;
