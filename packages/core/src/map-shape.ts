/**
 * Shapes that are still of their kind when space is mapped. Whether they are is decided by the structure of the map and
 * by numbers that are equal to the last bit: when in doubt the shape stays where it is, and rays are mapped instead.
 */
import { type Affine, times } from './affine.ts';
import type { ShapeKind } from './primitives/index.ts';
import { planeAxes } from './primitives/plane.ts';
import type { Shape } from './schema.ts';
import { cross, dot, length, normalize, subtract, type Vec3 } from './vector.ts';

type Mapping<K extends ShapeKind> = (shape: Shape<K>, map: Affine) => Shape<K> | undefined;

/** A shape as it is after a map, if it is then of the same kind. `patterned`: what is on its surface goes along. */
export function mapShape<K extends ShapeKind>(shape: Shape<K>, map: Affine, patterned: boolean): Shape<K> | undefined {
  if (patterned && !(carriesFrame[shape.type as ShapeKind] ? isRigid(map) : isUpright(map))) return undefined;
  return (mappings[shape.type as K] as Mapping<K>)(shape, map);
}

/** The kinds that say themselves where their U and V run. On others they start from the axes of space. */
const carriesFrame: { readonly [K in ShapeKind]: boolean } = {
  sphere: false,
  plane: true,
  disc: true,
  quad: true,
  box: false,
  cylinder: false,
  cone: false,
  torus: false,
  triangle: true,
};

/** Whether a map turns, moves and scales all lengths alike, and left and right stay what they are. */
const isRigid = (map: Affine): boolean => !map.rest && !map.mirrors;

/** Whether a map moves and scales all lengths alike, and nothing else. */
const isUpright = ({ columns: [x, y, z], factor }: Affine): boolean =>
  [...x, ...y, ...z].every((value, i) => value === (i % 4 === 0 ? factor : 0));

const mappings: { readonly [K in ShapeKind]: Mapping<K> } = {
  sphere: (shape, map) =>
    map.rest ? undefined : { ...shape, center: map.point(shape.center), radius: shape.radius * map.factor },
  plane: (shape, map) => ({ ...shape, point: map.point(shape.point), ...facing(shape, map) }),
  disc(shape, map) {
    const { tangent, bitangent } = planeAxes(shape);
    const widening = across(map, tangent, bitangent);
    if (!widening) return undefined;
    return { ...shape, center: map.point(shape.center), radius: shape.radius * widening, ...facing(shape, map) };
  },
  quad(shape, map) {
    const [edgeU, edgeV] = [map.direction(shape.edgeU), map.direction(shape.edgeV)];
    // In a mirror, the front is the front of the other order.
    const edges = map.mirrors ? { edgeU: edgeV, edgeV: edgeU } : { edgeU, edgeV };
    return { ...shape, corner: map.point(shape.corner), ...edges };
  },
  box(shape, map) {
    const axes = map.columns.map((column) => column.filter((value) => value !== 0).length);
    if (axes.some((count) => count !== 1)) return undefined;
    const size = map.direction(shape.size).map(Math.abs) as unknown as Vec3;
    return { ...shape, center: map.point(shape.center), size };
  },
  cylinder(shape, map) {
    const widening = around(map, subtract(shape.top, shape.base));
    if (!widening) return undefined;
    return { ...shape, base: map.point(shape.base), top: map.point(shape.top), radius: shape.radius * widening };
  },
  cone(shape, map) {
    const widening = around(map, subtract(shape.tip, shape.base));
    if (!widening) return undefined;
    return { ...shape, base: map.point(shape.base), tip: map.point(shape.tip), radius: shape.radius * widening };
  },
  torus(shape, map) {
    if (map.rest) return undefined;
    const { center, axis, radius, tube } = shape;
    const { factor } = map;
    const turned = normalize(map.direction(normalize(axis)));
    return { ...shape, center: map.point(center), axis: turned, radius: radius * factor, tube: tube * factor };
  },
  triangle(shape, map) {
    const [a, b, c] = [map.point(shape.a), map.point(shape.b), map.point(shape.c)];
    return map.mirrors ? { ...shape, a, b: c, c: b } : { ...shape, a, b, c };
  },
};

/** The normal of the front and the direction of U, where a map takes them. */
function facing(shape: { readonly normal: Vec3; readonly tangent?: Vec3 }, map: Affine) {
  const { normal, tangent } = planeAxes(shape);
  return { normal: normalize(map.normal(normal)), tangent: normalize(map.direction(tangent)) };
}

/** How much longer a map makes all lengths between two directions; undefined if not all alike. */
function across({ factor, rest }: Affine, tangent: Vec3, bitangent: Vec3): number | undefined {
  if (!rest) return factor;
  const [u, v] = [times(rest, tangent), times(rest, bitangent)];
  return dot(u, v) === 0 && length(u) === length(v) ? factor * length(u) : undefined;
}

/** The same, around an axis that stays perpendicular to what it is perpendicular to. */
function around(map: Affine, along: Vec3): number | undefined {
  const { normal, tangent, bitangent } = planeAxes({ normal: along });
  const { rest } = map;
  if (rest && length(cross(times(rest, normal), cross(times(rest, tangent), times(rest, bitangent)))) !== 0)
    return undefined;
  return across(map, tangent, bitangent);
}
