/** What must hold between the fields of one node, beyond each field's own range. */
import { say } from './say.ts';
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

const upright: Rule = ({ normal, tangent }) => [isParallel(normal, tangent) && say('parallelTangent')];

const softWithoutDecay: Rule = ({ radius = 0, decay }) => [radius > 0 && decay === 0 && say('softWithoutDecay')];

const rules: { readonly [label: string]: Rule } = {
  plane: upright,
  disc: upright,
  cylinder: ({ base, top }) => [isSame(base, top) && say('noHeight')],
  cone: ({ base, tip }) => [isSame(base, tip) && say('flatCone')],
  quad: ({ edgeU, edgeV }) => [isParallel(edgeU, edgeV) && say('parallelEdges')],
  triangle: ({ a, b, c }) => [!!a && !!b && !!c && isFlat(a, b, c) && say('cornersInLine')],
  torus: ({ radius = Number.POSITIVE_INFINITY, tube = 0 }) => [tube >= radius && say('fatTorus', tube, radius)],
  camera: ({ position, target = ORIGIN }) => [isSame(target, position) && say('cameraToNowhere')],
  'point light': softWithoutDecay,
  'spot light': (node) => [
    ...softWithoutDecay(node),
    !!node.direction && !!node.target && say('directionAndTarget'),
    !node.direction && isSame(node.target ?? ORIGIN, node.position) && say('lightToNowhere'),
  ],
  'directional light': ({ direction, position, target }) => [
    !!direction && (!!position || !!target) && say('directionAndPosition'),
    !!target && !position && say('targetAlone'),
    isSame(target ?? ORIGIN, position) && say('lightToNowhere'),
  ],
  environment: ({ color, top, bottom, src }) => [
    !!src && (!!color || !!top || !!bottom) && say('imageAndColors'),
    !!color && (!!top || !!bottom) && say('colorAndGradient'),
    !color && !!top !== !!bottom && say('halfGradient'),
  ],
};

/** What to say of each thing that does not fit together in a node. */
export const contradiction = (label: string, node: object): readonly string[] =>
  (rules[label]?.(node) ?? []).filter((problem) => problem !== false);
