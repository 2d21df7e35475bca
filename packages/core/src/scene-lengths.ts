/**
 * Lengths of a scene that are too far apart, and factors of groups that are too far from 1. Pictures are those of f64 up to
 * this ratio, as measured: next to a planet that is ten times as large, f64 itself would hold where a ball is no better than
 * to a hundredth of the ball.
 */
import { type Field, LARGEST_FACTOR } from './fields.ts';
import { primitives } from './primitives/index.ts';
import { say } from './say.ts';
import type { Locate, Problem } from './scene-error.ts';
import type { Group, Light, Scene, SceneNode, SceneObject } from './schema.ts';
import { length, subtract, type Vec3 } from './vector.ts';

/** How many times another one a length of the same scene may be. */
export const LARGEST_RATIO = 1e13;

type Path = Problem['path'];

/** A node, and its smallest size and its largest length or distance from the origin, in the scene's unit. */
interface Measured {
  readonly path: Path;
  readonly least: number;
  readonly most: number;
}

const NOTHING: Measured = { path: [], least: Number.POSITIVE_INFINITY, most: 0 };

/** What lengths are multiplied by, along the axis where that is least and where it is most. */
type Factors = readonly [least: number, most: number];

/**
 * What is wrong with the factors of groups and, if nothing else is (`known`), with the smallest size and the largest length
 * of a scene. What groups scale counts as if it were scaled as much along all axes.
 */
export function lengthProblems(scene: Scene, locate: Locate, known: readonly Problem[]): readonly Problem[] {
  const factors = factorProblems([], scene.objects, [1, 1], locate);
  if (known.length + factors.length > 0) return factors;
  const { camera } = scene;
  const all = [
    ...(camera?.position ? [measured(['camera'], [], [camera.position])] : []),
    ...nodesWithin([], scene, [1, 1]),
  ];
  const { path, least } = all.reduce((best, node) => (node.least < best.least ? node : best), NOTHING);
  const largest = all.reduce((best, node) => (node.most > best.most ? node : best), NOTHING);
  if (largest.most <= LARGEST_RATIO * least) return [];
  return [{ path, where: locate(path), message: say('farApart', least, largest.most, locate(largest.path)) }];
}

/** Of groups within groups; in those that go too far, nobody looks further. Nodes that could not be read are undefined. */
function factorProblems(
  above: Path,
  nodes: readonly (SceneNode | undefined)[],
  by: Factors,
  locate: Locate,
): Problem[] {
  return nodes.flatMap((node, i) => {
    if (node?.type !== 'group') return [];
    const path = [...above, 'objects', i];
    const [least, most] = within(node, by);
    if (Math.max(most, 1 / least, most / least) > LARGEST_FACTOR) {
      return [{ path, where: locate(path), message: say('scales') }];
    }
    return factorProblems(path, node.objects, [least, most], locate);
  });
}

/** What a group makes of the factors that it is in the reach of. */
function within({ scale }: Partial<Pick<Group, 'scale'>>, [least, most]: Factors): Factors {
  const own = scale?.map(Math.abs) ?? [1];
  return [least * Math.min(...own), most * Math.max(...own)];
}

function nodesWithin(path: Path, { lights, objects }: Pick<Scene, 'lights' | 'objects'>, by: Factors): Measured[] {
  return [
    ...lights.map((light, i) => measuredLight([...path, 'lights', i], light, by)),
    ...objects.flatMap((node, i) => measuredNode([...path, 'objects', i], node, by)),
  ];
}

function measuredLight(path: Path, light: Light, by: Factors): Measured {
  if (light.type === 'directional') return measured(path, [], []);
  return measured(path, light.radius > 0 ? [light.radius] : [], [light.position], by);
}

function measuredNode(path: Path, node: SceneNode, by: Factors): Measured[] {
  if (node.type !== 'group') return [measured(path, sizesOf(node), placesOf(node), by)];
  return [measured(path, [], [node.position], by), ...nodesWithin(path, node, within(node, by))];
}

const measured = (path: Path, own: readonly number[], places: readonly Vec3[], [least, most]: Factors = [1, 1]) => ({
  path,
  least: least * Math.min(...own),
  most: most * Math.max(0, ...own, ...places.map(length)),
});

/** An object's fields of a kind of value, as its table has them. */
const valuesOf = <T>(object: SceneObject, is: (field: Field<unknown>) => boolean): readonly T[] =>
  Object.entries(primitives[object.type].fields)
    .filter(([, field]) => is(field))
    .map(([name]) => object[name as keyof SceneObject] as unknown as T);

/** Vectors that are neither directions nor sizes. */
const placesOf = (object: SceneObject): readonly Vec3[] =>
  valuesOf(object, ({ kind, limits }) => kind === 'vector' && !limits.nonzero && limits.above === undefined);

/** How large an object is, in every respect in which it has a size: all numbers of a shape are lengths. */
function sizesOf(object: SceneObject): readonly number[] {
  const places = placesOf(object);
  return [
    ...valuesOf<number>(object, ({ kind }) => kind === 'number'),
    ...valuesOf<Vec3>(object, ({ kind, limits }) => kind === 'vector' && limits.above !== undefined).flat(),
    ...valuesOf<Vec3>(object, ({ limits }) => !!limits.edge).map(length),
    ...places.flatMap((place, i) => places.slice(i + 1).map((other) => length(subtract(other, place)))),
  ];
}
