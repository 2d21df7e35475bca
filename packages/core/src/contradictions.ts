/** What must hold between the fields of one node, beyond each field's own range. */
import { cross, length, subtract, type Vec3 } from './vector.ts';

type VectorField =
  | ('normal' | 'tangent' | 'base' | 'top' | 'tip' | 'edgeU' | 'edgeV' | 'a' | 'b' | 'c')
  | ('position' | 'target' | 'direction' | 'color' | 'bottom');

/** What could be read of a node. */
type NodeValues = { readonly [V in VectorField]?: Vec3 } & {
  readonly radius?: number;
  readonly tube?: number;
  readonly decay?: number;
  readonly src?: string;
};

type Rule = (node: NodeValues) => readonly (string | false)[];

const unit = (v: Vec3): Vec3 => {
  const largest = Math.max(...v.map(Math.abs)) || 1;
  return v.map((x) => x / largest) as unknown as Vec3;
};

const isParallel = (a?: Vec3, b?: Vec3): boolean => !!a && !!b && length(cross(unit(a), unit(b))) < Number.EPSILON;

const isSame = (a?: Vec3, b?: Vec3): boolean => !!a && !!b && length(subtract(a, b)) === 0;

const isFlat = (a: Vec3, b: Vec3, c: Vec3): boolean =>
  isParallel(subtract(b, a), subtract(c, a)) || isParallel(subtract(c, b), subtract(a, b));

/** What targets are that are left out. */
const ORIGIN: Vec3 = [0, 0, 0];

const upright: Rule = ({ normal, tangent }) => [
  isParallel(normal, tangent) && 'tangent must not be parallel to the normal',
];

const NOWHERE = 'target must not be the position: the light would go nowhere';

const softWithoutDecay: Rule = ({ radius = 0, decay }) => [
  radius > 0 && decay === 0 && 'decay must be 2 where there is a radius: a ball of light fades as light does',
];

const rules: { readonly [label: string]: Rule } = {
  plane: upright,
  disc: upright,
  cylinder: ({ base, top }) => [isSame(base, top) && 'top must not be the base: the cylinder would have no height'],
  cone: ({ base, tip }) => [isSame(base, tip) && 'tip must not be in the base: the cone would have no height'],
  quad: ({ edgeU, edgeV }) => [isParallel(edgeU, edgeV) && 'edges must not be parallel: the quad would have no area'],
  triangle: ({ a, b, c }) => [
    !!a && !!b && !!c && isFlat(a, b, c) && 'corners must not be in a line: there is no area',
  ],
  torus: ({ radius = Number.POSITIVE_INFINITY, tube = 0 }) => [
    tube >= radius &&
      `tube must be below the radius, not ${tube} for a radius of ${radius}: it would fill its own hole`,
  ],
  camera: ({ position, target = ORIGIN }) => [
    isSame(target, position) && 'target must not be the position: the camera would look nowhere',
  ],
  'point light': softWithoutDecay,
  'spot light': (node) => [
    ...softWithoutDecay(node),
    !!node.direction && !!node.target && 'takes a direction or a target, not both',
    !node.direction && isSame(node.target ?? ORIGIN, node.position) && NOWHERE,
  ],
  'directional light': ({ direction, position, target }) => [
    !!direction && (!!position || !!target) && 'takes a direction, or a position and a target, not both',
    !!target && !position && 'a target needs a position',
    isSame(target ?? ORIGIN, position) && NOWHERE,
  ],
  environment: ({ color, top, bottom, src }) => [
    !!src && (!!color || !!top || !!bottom) && 'takes a src or colours, not both',
    !!color && (!!top || !!bottom) && 'takes a color, or top and bottom, not both',
    !color && !!top !== !!bottom && 'top and bottom belong together',
  ],
};

/** One sentence for each thing that does not fit together in a node. */
export const contradiction = (label: string, node: object): readonly string[] =>
  (rules[label]?.(node) ?? []).filter((problem) => problem !== false);
