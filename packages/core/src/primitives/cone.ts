import { number, vector } from '../fields.ts';

/** What an author may say of a cone. */
export const coneTable = {
  doc:
    'A solid cone with a base. On the side, U is the arc from the tangent (x, or z where the axis is nearly x) and V the ' +
    'height above the base; on the base U runs along the tangent, V along axis × tangent, from the middle.',
  fields: {
    base: vector('Middle of the base.', { default: [0, -0.5, 0] }),
    tip: vector('The tip.', { default: [0, 0.5, 0] }),
    radius: number('Radius of the base.', { default: 0.5, above: 0 }),
  },
} as const;
