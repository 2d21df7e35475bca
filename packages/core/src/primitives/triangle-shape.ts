import { toFrame } from '../frame.ts';
import { cross, dot, length, normalize, subtract, type Vec3 } from '../vector.ts';
import { cellMembers, lowWord, normalMembers, packCells, packNormal } from './flat.ts';
import { definePrimitive } from './primitive.ts';
import { triangleTable } from './triangle.ts';

export const triangle = definePrimitive({
  ...triangleTable,
  record: [
    { name: 'a', type: 'vec3' },
    { name: 'aLow', type: 'vec3', when: 'wideRange' },
    { name: 'b', type: 'vec3' },
    { name: 'bLow', type: 'vec3', when: 'wideRange' },
    { name: 'c', type: 'vec3' },
    { name: 'cLow', type: 'vec3', when: 'wideRange' },
    ...normalMembers,
    { name: 'height', type: 'float' },
    ...cellMembers('triangle'),
  ],
  pack(shape, frame, { checkerSize, wideRange }) {
    const [a, b, c] = [toFrame(frame, shape.a), toFrame(frame, shape.b), toFrame(frame, shape.c)];
    const normal = triangleNormal(shape);
    const u = normalize(subtract(shape.b, shape.a));
    return {
      a,
      aLow: lowWord(a),
      b,
      bLow: lowWord(b),
      c,
      cLow: lowWord(c),
      ...packNormal(normal, wideRange),
      height: dot(normal, a),
      ...packCells(frame, shape.a, u, cross(normal, u), checkerSize),
    };
  },
  closed: false,
  bounds: ({ a, b, c }) => ({
    min: [0, 1, 2].map((i) => Math.min(a[i] as number, b[i] as number, c[i] as number)) as unknown as Vec3,
    max: [0, 1, 2].map((i) => Math.max(a[i] as number, b[i] as number, c[i] as number)) as unknown as Vec3,
  }),
  extent: ({ a, b, c }, frame) => Math.max(...[a, b, c].map((corner) => length(toFrame(frame, corner)))),
  // Its smallest height.
  size({ a, b, c }) {
    const [ab, ac] = [subtract(b, a), subtract(c, a)];
    return length(cross(ab, ac)) / Math.max(length(ab), length(ac), length(subtract(c, b)));
  },
  clearance(shape, point) {
    const reach = Math.max(length(subtract(shape.b, shape.a)), length(subtract(shape.c, shape.a)));
    const away = subtract(point, shape.a);
    return Math.max(Math.abs(dot(triangleNormal(shape), away)), length(away) - reach);
  },
  side: () => 1,
  farSide: () => 1,
  occludes: () => true,
});

/** The unit normal of the front, from the two shorter edges: they leave the least to cancel in a sliver. */
export function triangleNormal({ a, b, c }: { readonly a: Vec3; readonly b: Vec3; readonly c: Vec3 }): Vec3 {
  const edges = [subtract(b, a), subtract(c, b), subtract(a, c)] as const;
  const longest = edges.map(length).reduce((best, size, i, all) => (size > (all[best] as number) ? i : best), 0);
  const [first, second] = [edges[(longest + 1) % 3] as Vec3, edges[(longest + 2) % 3] as Vec3];
  return normalize(cross(normalize(first), normalize(second)));
}
