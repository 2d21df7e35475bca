/** What must hold between the fields of one node, beyond each field's own range. */
import { cross, length, subtract, type Vec3 } from './vector.ts';

type NodeValues = { readonly [field: string]: unknown };

const parallel = (a: unknown, b: unknown): boolean => length(cross(unit(a), unit(b))) < Number.EPSILON;

const unit = (v: unknown): Vec3 => {
  const [x, y, z] = v as Vec3;
  const largest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) || 1;
  return [x / largest, y / largest, z / largest];
};

const isSame = (a: unknown, b: unknown): boolean => !!a && !!b && length(subtract(a as Vec3, b as Vec3)) === 0;

const isFlat = (a: Vec3, b: Vec3, c: Vec3): boolean =>
  parallel(subtract(b, a), subtract(c, a)) || parallel(subtract(c, b), subtract(a, b));

const softWithoutDecay = ({ radius, decay }: NodeValues): readonly (string | false)[] => [
  (radius as number) > 0 &&
    decay === 0 &&
    'decay must be 2 where there is a radius: a ball of light fades as light does',
];

const rules: { readonly [label: string]: (node: NodeValues) => readonly (string | false)[] } = {
  plane: ({ normal, tangent }) => [
    !!normal && !!tangent && parallel(normal, tangent) && 'tangent must not be parallel to the normal',
  ],
  disc: ({ normal, tangent }) => [
    !!normal && !!tangent && parallel(normal, tangent) && 'tangent must not be parallel to the normal',
  ],
  cylinder: ({ base, top }) => [isSame(base, top) && 'top must not be the base: the cylinder would have no height'],
  cone: ({ base, tip }) => [isSame(base, tip) && 'tip must not be in the base: the cone would have no height'],
  quad: ({ edgeU, edgeV }) => [
    !!edgeU && !!edgeV && parallel(edgeU, edgeV) && 'edges must not be parallel: the quad would have no area',
  ],
  triangle: ({ a, b, c }) => [
    !!a && !!b && !!c && isFlat(a as Vec3, b as Vec3, c as Vec3) && 'corners must not be in a line: there is no area',
  ],
  torus: ({ radius, tube }) => [
    (tube as number) >= (radius as number) &&
      `tube must be below the radius, not ${tube} for a radius of ${radius}: it would fill its own hole`,
  ],
  camera: ({ position, target }) => [
    !!position &&
      length(subtract((target as Vec3 | undefined) ?? [0, 0, 0], position as Vec3)) === 0 &&
      'target must not be the position: the camera would look nowhere',
  ],
  'point light': softWithoutDecay,
  'spot light': (node) => [
    ...softWithoutDecay(node),
    !!node.direction && !!node.target && 'takes a direction or a target, not both',
    !node.direction &&
      isSame((node.target as Vec3 | undefined) ?? [0, 0, 0], node.position) &&
      'target must not be the position: the light would go nowhere',
  ],
  'directional light': ({ direction, position, target }) => [
    !!direction && !!(position || target) && 'takes a direction, or a position and a target, not both',
    !!target && !position && 'a target needs a position',
    position && length(subtract((target as Vec3 | undefined) ?? [0, 0, 0], position as Vec3)) === 0
      ? 'target must not be the position: the light would go nowhere'
      : false,
  ],
  environment: ({ color, top, bottom, src }) => [
    !!src && !!(color || top || bottom) && 'takes a src or colours, not both',
    !!color && !!(top || bottom) && 'takes a color, or top and bottom, not both',
    !color && !!top !== !!bottom && 'top and bottom belong together',
  ],
};

/** One sentence for each thing that does not fit together in a node. */
export const contradiction = (label: string, node: NodeValues): readonly string[] =>
  (rules[label]?.(node) ?? []).filter((problem) => problem !== false);
