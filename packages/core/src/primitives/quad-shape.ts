import { toFrame } from '../frame.ts';
import { add, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../vector.ts';
import { cellMembers, duals, lowWord, normalMembers, packCells, packNormal } from './flat.ts';
import { definePrimitive } from './primitive.ts';
import { quadTable } from './quad.ts';

export const quad = definePrimitive({
  ...quadTable,
  record: [
    { name: 'corner', type: 'vec3' },
    { name: 'cornerLow', type: 'vec3', when: 'wideRange' },
    ...normalMembers,
    { name: 'height', type: 'float' },
    { name: 'edgeU', type: 'vec3' },
    { name: 'edgeV', type: 'vec3' },
    { name: 'alongU', type: 'vec3' },
    { name: 'alongV', type: 'vec3' },
    ...cellMembers('quad'),
  ],
  pack(shape, frame, { checkerSize, wideRange }) {
    const corner = toFrame(frame, shape.corner);
    const [edgeU, edgeV] = [scale(shape.edgeU, frame.scale), scale(shape.edgeV, frame.scale)];
    const normal = quadNormal(shape);
    const area = length(cross(edgeU, edgeV));
    const [u, v] = duals(shape.edgeU, shape.edgeV);
    return {
      corner,
      cornerLow: lowWord(corner),
      ...packNormal(normal, wideRange),
      height: dot(normal, corner),
      // Over the area, so that u and v of a point come out as parts of normal·d.
      edgeU: scale(edgeU, 1 / area),
      edgeV: scale(edgeV, 1 / area),
      alongU: scale(cross(edgeV, corner), 1 / area),
      alongV: scale(cross(corner, edgeU), 1 / area),
      ...packCells(frame, shape.corner, scale(u, length(shape.edgeU)), scale(v, length(shape.edgeV)), checkerSize),
    };
  },
  closed: false,
  bounds(shape) {
    const corners = quadCorners(shape);
    return {
      min: [0, 1, 2].map((i) => Math.min(...corners.map((c) => c[i] as number))) as unknown as Vec3,
      max: [0, 1, 2].map((i) => Math.max(...corners.map((c) => c[i] as number))) as unknown as Vec3,
    };
  },
  extent: (shape, frame) => Math.max(...quadCorners(shape).map((corner) => length(toFrame(frame, corner)))),
  // How far the longer edge is from the side across.
  size: ({ edgeU, edgeV }) => length(cross(edgeU, edgeV)) / Math.max(length(edgeU), length(edgeV)),
  clearance(shape, point) {
    const [middle, reach] = [scale(add(shape.edgeU, shape.edgeV), 0.5), length(shape.edgeU) + length(shape.edgeV)];
    const away = length(subtract(point, add(shape.corner, middle)));
    const height = Math.abs(dot(quadNormal(shape), subtract(point, shape.corner)));
    return Math.max(height, away - reach / 2);
  },
  side: () => 1,
  farSide: () => 1,
  occludes: () => true,
});

/** The unit normal of the front. */
export const quadNormal = ({ edgeU, edgeV }: { readonly edgeU: Vec3; readonly edgeV: Vec3 }): Vec3 =>
  normalize(cross(normalize(edgeU), normalize(edgeV)));

const quadCorners = ({ corner, edgeU, edgeV }: { corner: Vec3; edgeU: Vec3; edgeV: Vec3 }): readonly Vec3[] => {
  const across = add(corner, edgeU);
  return [corner, across, add(corner, edgeV), add(across, edgeV)];
};
