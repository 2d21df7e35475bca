import { number, vector } from '../fields.ts';

/** What an author may say of a disc. */
export const discTable = {
  doc: 'A round plate without thickness. U runs along the tangent, V along normal × tangent, both from the centre.',
  fields: {
    center: vector('Centre.', { default: [0, 0, 0] }),
    normal: vector('The direction it faces.', { default: [0, 1, 0], nonzero: true }),
    radius: number('Radius.', { default: 1, above: 0 }),
    tangent: vector('The direction of U; default: the x axis, or z where the normal is nearly x.', { nonzero: true }),
  },
} as const;
