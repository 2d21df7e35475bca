/**
 * Pairs of a ball with a narrow reflecting lobe and a lamp without extent. A path that comes from a surface on which the
 * ball throws a glint of the lamp finds it on purpose (`shaders/glint.glsl`): by chance it hardly ever would.
 */
import type { Emitter } from './emitters.ts';
import type { Feature } from './features.ts';
import { type Frame, toFrame } from './frame.ts';
import { dielectricReflectance, ggxAlpha } from './material-record.ts';
import type { ResolvedObject, ResolvedScene } from './resolve-scene.ts';
import type { Material, Shape } from './schema.ts';
import type { RecordValues } from './std140.ts';
import { length, mix, normalize, subtract, type Vec3 } from './vector.ts';

/** In scene coordinates. */
export interface Glint {
  /** Number of the ball among the objects of the scene. */
  readonly object: number;
  readonly center: Vec3;
  readonly radius: number;
  /** GGX, of the ball. */
  readonly alpha: number;
  /** Unit vector from the centre to the lamp. */
  readonly toLamp: Vec3;
  /** The ball's radius over the lamp's distance from its centre. */
  readonly nearness: number;
  /** Reflectance of the ball straight on, times the lamp's share in the power of all lamps. */
  readonly strength: number;
}

/**
 * The reflectance over the solid angle of a lobe, π alpha², from which on a glint is looked for: an alpha up to 0.23 of a
 * metal, to 0.046 of glass or plastic. There the variance of a path from a floor beside the ball is a quarter of what it is
 * by chance, for up to twice the time.
 */
const LEAST_PEAK = 6;

/** What a shader has of pairs, one by one; those beyond these, the weakest, are left to chance. */
export const GLINT_FEATURES = [
  'glint',
  'secondGlint',
  'thirdGlint',
  'fourthGlint',
] as const satisfies readonly Feature[];

export const glintRecord = [
  { name: 'center', type: 'vec3', when: 'glint' },
  { name: 'radius', type: 'float', when: 'glint' },
  { name: 'toLamp', type: 'vec3', when: 'glint' },
  { name: 'nearness', type: 'float', when: 'glint' },
  { name: 'object', type: 'int', when: 'glint' },
  { name: 'alpha', type: 'float', when: 'glint' },
  { name: 'strength', type: 'float', when: 'glint' },
] as const;

/** Of places that no pair fills. */
export const ABSENT_GLINT: RecordValues<typeof glintRecord> = {
  center: [0, 0, 0],
  radius: 1,
  toLamp: [0, 0, 1],
  nearness: 0,
  object: -1,
  alpha: 1,
  strength: 0,
};

/** `object`: the ball's number in the shader. */
export const packGlint = (glint: Glint, frame: Frame, object: number): RecordValues<typeof glintRecord> => ({
  ...glint,
  center: toFrame(frame, glint.center),
  radius: glint.radius * frame.scale,
  object,
});

type PointLike = Extract<Emitter, { kind: 'point' | 'spot' | 'directional' }>;

/** How many pairs a shader has places for. */
export const glintPlaces = (features: readonly Feature[]): number =>
  GLINT_FEATURES.filter((feature) => features.includes(feature)).length;

/** How many pairs there are, however weak: numbers that move no more than an edge of a feature do not change it. */
export const countGlints = (scene: ResolvedScene, emitters: readonly Emitter[]): number =>
  narrowBalls(scene).length * emitters.filter(isPointLike).length;

/** The strongest pairs. */
export function sceneGlints(scene: ResolvedScene, emitters: readonly Emitter[]): readonly Glint[] {
  const power = emitters.reduce((sum, one) => sum + one.power, 0);
  const pairs = narrowBalls(scene).flatMap((object) =>
    emitters
      .filter(isPointLike)
      .filter((lamp) => lamp.power > 0)
      .map((lamp) => glintOf(scene, object, lamp, lamp.power / power)),
  );
  return pairs.sort((a, b) => b.strength * b.radius ** 2 - a.strength * a.radius ** 2).slice(0, GLINT_FEATURES.length);
}

const isPointLike = (emitter: Emitter): emitter is PointLike =>
  emitter.kind === 'point' || emitter.kind === 'spot' || emitter.kind === 'directional';

/** Balls in a space of their own are not among them. */
const narrowBalls = ({ objects, materials }: ResolvedScene): readonly ResolvedObject[] =>
  objects.filter(({ shape, material: index }) => {
    const material = materials[index] as Material;
    const alpha = ggxAlpha(material.roughness);
    // As of a white metal, so that a change of colour compiles nothing.
    const reflectance = average(mix(dielectricReflectance(material).f0, [1, 1, 1], material.metalness));
    const isNarrow = alpha > 0 && reflectance > 0 && reflectance >= LEAST_PEAK * Math.PI * alpha ** 2;
    return shape.type === 'sphere' && !shape.place && isNarrow;
  });

const average = ([r, g, b]: Vec3): number => (r + g + b) / 3;

function glintOf({ objects, materials }: ResolvedScene, ball: ResolvedObject, lamp: PointLike, share: number): Glint {
  const { center, radius } = ball.shape as unknown as Shape<'sphere'>;
  const material = materials[ball.material] as Material;
  const { f0 } = dielectricReflectance(material);
  const way = lamp.kind === 'directional' ? lamp.toLight : subtract(lamp.position, center);
  return {
    object: objects.indexOf(ball),
    center,
    radius,
    alpha: ggxAlpha(material.roughness),
    toLamp: normalize(way),
    nearness: lamp.kind === 'directional' ? 0 : radius / length(way),
    strength: share * average(mix(f0, material.color, material.metalness)),
  };
}
