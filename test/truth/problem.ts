/** A case as a question that the reference and the GPU can both be asked: a ray against a scene seen by a camera. */
import type { Vec3 } from '@ray-scene/core';
import { add, addScaled, length, scale, subtract } from '../../packages/core/src/vector.ts';
import type { Shape, VectorCase, VectorKind, WatertightCase } from './vector-cases.ts';

export interface Problem {
  /** As in a scene file. */
  readonly objects: readonly { readonly type: string }[];
  readonly camera: Vec3;
  readonly origin: Vec3;
  /** Not of unit length: t is in units of it. */
  readonly direction: Vec3;
  /** The ray leaves the surface of the first object. */
  readonly own: boolean;
}

/** What a ray meets. */
export interface Answer {
  /** Infinity for nothing. */
  readonly t: number;
  readonly normal: Vec3;
}

interface Mapping {
  /** The fields that are places; the others are lengths and directions. */
  readonly positions: readonly string[];
  readonly object: (p: never) => object;
  /** A length that says how large it is; 0 for what has none. */
  readonly size: (p: never) => number;
}

type Numbers<V extends string, N extends string = never> = { readonly [K in V]: Vec3 } & { readonly [K in N]: number };

const mappings: { readonly [K in VectorKind]: Mapping } = {
  sphere: {
    positions: ['center'],
    object: ({ center, radius }: Numbers<'center', 'radius'>) => ({ center, radius }),
    size: ({ radius }: Numbers<never, 'radius'>) => radius,
  },
  plane: {
    positions: ['point'],
    object: ({ point, normal }: Numbers<'point' | 'normal'>) => ({ point, normal }),
    size: () => 0,
  },
  disc: {
    positions: ['center'],
    object: ({ center, normal, radius }: Numbers<'center' | 'normal', 'radius'>) => ({ center, normal, radius }),
    size: ({ radius }: Numbers<never, 'radius'>) => radius,
  },
  quad: {
    positions: ['corner'],
    object: ({ corner, edgeU, edgeV }: Numbers<'corner' | 'edgeU' | 'edgeV'>) => ({ corner, edgeU, edgeV }),
    size: ({ edgeU, edgeV }: Numbers<'edgeU' | 'edgeV'>) => Math.max(length(edgeU), length(edgeV)),
  },
  box: {
    positions: ['min', 'max'],
    object: ({ min, max }: Numbers<'min' | 'max'>) => ({
      center: scale(add(min, max), 0.5),
      size: subtract(max, min),
    }),
    size: ({ min, max }: Numbers<'min' | 'max'>) => length(subtract(max, min)),
  },
  cylinder: {
    positions: ['a', 'b'],
    object: ({ a, b, radius }: Numbers<'a' | 'b', 'radius'>) => ({ base: a, top: b, radius }),
    size: ({ a, b, radius }: Numbers<'a' | 'b', 'radius'>) => Math.max(length(subtract(b, a)), radius),
  },
  cone: {
    positions: ['a', 'b'],
    object: ({ a, b, radius }: Numbers<'a' | 'b', 'radius'>) => ({ base: a, tip: b, radius }),
    size: ({ a, b, radius }: Numbers<'a' | 'b', 'radius'>) => Math.max(length(subtract(b, a)), radius),
  },
  torus: {
    positions: ['center'],
    object: ({ center, axis, major, minor }: Numbers<'center' | 'axis', 'major' | 'minor'>) => ({
      center,
      axis,
      radius: major,
      tube: minor,
    }),
    size: ({ major, minor }: Numbers<never, 'major' | 'minor'>) => major + minor,
  },
  triangle: {
    positions: ['a', 'b', 'c'],
    object: ({ a, b, c }: Numbers<'a' | 'b' | 'c'>) => ({ a, b, c }),
    size: ({ a, b, c }: Numbers<'a' | 'b' | 'c'>) => Math.max(length(subtract(b, a)), length(subtract(c, a))),
  },
};

/** The fields of a primitive that are places. */
export const positionsOf = (kind: VectorKind): readonly string[] => mappings[kind].positions;

const objectOf = (kind: VectorKind, p: Shape) => ({ type: kind, ...mappings[kind].object(p as never) });

/** The ray of a case, from the camera. */
export const cameraProblem = ({
  prim,
  p,
  o,
  d,
  tmin,
}: Pick<VectorCase, 'prim' | 'p' | 'o' | 'd' | 'tmin'>): Problem => ({
  objects: [objectOf(prim, p)],
  camera: o,
  origin: o,
  direction: d,
  own: tmin > 0,
});

/**
 * The case with the camera, which is the origin then, away from the ray's origin, at 3 t in a direction that the case's
 * name stands for. All places are rounded to f32: another case, almost the same.
 */
export function secondaryCase(one: VectorCase): VectorCase {
  const { id, prim, p, o, t64 } = one;
  const size = mappings[prim].size(p as never) || length(subtract(p[mappings[prim].positions[0] as string] as Vec3, o));
  const camera = addScaled(o, seededDirection(id), 3 * (t64 ?? (size || 1)));
  const places = mappings[prim].positions.map((field) => [field, relativeTo(camera, p[field] as Vec3)]);
  return { ...one, p: { ...p, ...Object.fromEntries(places) }, o: relativeTo(camera, o) };
}

/** The ray of a case that is `secondaryCase` already, seen by a camera at the origin. */
export const secondaryProblem = (one: VectorCase): Problem => ({ ...cameraProblem(one), camera: [0, 0, 0] });

const relativeTo = (camera: Vec3, place: Vec3): Vec3 => rounded(subtract(place, camera));
const rounded = ([x, y, z]: Vec3): Vec3 => [Math.fround(x), Math.fround(y), Math.fround(z)];

/** Neighbouring triangles and a ray to what they share. */
export const watertightProblem = ({ tris, o, d }: WatertightCase): Problem => ({
  objects: tris.map(([a, b, c]) => ({ type: 'triangle', a, b, c })),
  camera: o,
  origin: o,
  direction: d,
  own: false,
});

/** The same with the camera elsewhere, and places rounded to f32. */
export function secondaryWatertightProblem({ id, tris, o, d }: WatertightCase): Problem {
  const reach = Math.max(...tris.flat().map((corner) => length(subtract(corner, o))));
  const camera = addScaled(o, seededDirection(id), 3 * reach);
  const moved = tris.map(
    ([a, b, c]) => [a, b, c].map((corner) => relativeTo(camera, corner)) as unknown as [Vec3, Vec3, Vec3],
  );
  return { ...watertightProblem({ id, tris: moved, o: relativeTo(camera, o), d, mustHit: true }), camera: [0, 0, 0] };
}

/** A direction for a name, uniform on the sphere. */
function seededDirection(name: string): Vec3 {
  const y = 2 * uniform(`${name}/y`) - 1;
  const angle = 2 * Math.PI * uniform(`${name}/angle`);
  const r = Math.sqrt(1 - y * y);
  return [r * Math.cos(angle), y, r * Math.sin(angle)];
}

/** FNV-1a and a finishing mix, as a number in [0, 1). */
function uniform(text: string): number {
  let hash = 0x811c9dc5;
  for (const character of text) hash = Math.imul(hash ^ character.charCodeAt(0), 0x01000193);
  hash = Math.imul(hash ^ (hash >>> 16), 0x45d9f3b);
  return ((hash ^ (hash >>> 16)) >>> 0) / 2 ** 32;
}
