import { vector } from '../fields.ts';

/** What an author may say of a triangle. */
export const triangleTable = {
  doc: 'A triangle; its front is where (b - a) × (c - a) points to. U runs from a to b, V across it, both from a.',
  fields: {
    a: vector('First corner.', { default: [-0.5, 0, 0] }),
    b: vector('Second corner.', { default: [0.5, 0, 0] }),
    c: vector('Third corner.', { default: [0, 1, 0] }),
  },
} as const;
