import { number, vector } from '../fields.ts';

/** What an author may say of a cylinder. */
export const cylinderTable = {
  doc:
    'A solid cylinder with caps. On the side, U is the arc from the tangent (x, or z where the axis is nearly x) and V the ' +
    'height above the base; on the caps U runs along the tangent, V along axis × tangent, from the middle.',
  fields: {
    base: vector('Middle of the one cap.', { default: [0, -0.5, 0] }),
    top: vector('Middle of the other.', { default: [0, 0.5, 0] }),
    radius: number('Radius.', { default: 0.5, above: 0 }),
  },
} as const;
