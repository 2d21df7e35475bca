/** Random scene files for fast-check, made from the table itself: a new field or kind is tested without a word here. */
import '@ray-scene/core/parts';
import { camera, type Fields, group, lights, Mismatch, material, parseScene, primitives } from '@ray-scene/core';
import fc from 'fast-check';

type Json = { [key: string]: unknown };

/**
 * A number as people write it, with few digits: in coarse steps or in fine ones. Of all doubles, nearly all are next to
 * nothing.
 */
const between = (least: number, most: number): fc.Arbitrary<number> =>
  fc.oneof(
    ...[1e6, 1e3, 1]
      .map((steps) => ({ steps, min: Math.ceil(least * steps), max: Math.floor(most * steps) }))
      .filter(({ min, max }) => min <= max)
      .map(({ steps, ...range }) => fc.integer(range).map((i) => Number((i / steps).toPrecision(6)))),
  );

const byKind = {
  vector: fc.tuple(...[1, 2, 3].map(() => between(-100, 100))),
  color: fc.oneof(
    fc.tuple(...[1, 2, 3].map(() => between(0, 1))),
    fc.constantFrom('crimson', '#08f', 'rgb(10 20 30)', 'hsl(120 50% 50%)', 'color(srgb-linear 0.2 0.3 0.4)'),
  ),
  name: fc.constantFrom('a', 'b', 'ball'),
  // A factor on lengths, or one for each axis; negative ones mirror.
  factors: fc.oneof(
    fc.constantFrom(-2, 0.5, 1e-3, 1e3),
    fc.tuple(...[1, 2, 3].map(() => fc.constantFrom(-1, 0.01, 0.3, 1, 2, 50))),
  ),
};

/** A value that a field accepts, in its JSON form. */
function valueFor({ kind, limits, read }: Fields[string]): fc.Arbitrary<unknown> {
  if (kind === 'choice') return fc.constantFrom(...(limits.choices ?? []));
  const { above = -100, min = above, max = 100 } = limits;
  const values: fc.Arbitrary<unknown> =
    kind === 'number' ? between(Math.max(min, -100), Math.min(max, 100)) : byKind[kind as keyof typeof byKind];
  return values.filter((value) => !(read(value) instanceof Mismatch));
}

/** Any of the fields of a node, each present or not. */
const nodeOf = (fields: Fields): fc.Arbitrary<Json> =>
  fc.record(Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, valueFor(field)])), {
    requiredKeys: [],
  });

const variantOf = (tables: { [kind: string]: { fields: Fields } }, extra: Fields = {}): fc.Arbitrary<Json> =>
  fc.oneof(
    ...Object.entries(tables).map(([type, { fields }]) =>
      nodeOf({ ...fields, ...extra }).map((node) => ({ ...node, type })),
    ),
  );

/** Takes away fields that contradict each other; what is left is a valid node. */
function consistent(node: Json): Json {
  if (node.type === 'torus') return withinRing(node);
  const { direction, position, target, tangent, up, decay, ...rest } = node;
  if (node.type === 'point') return position ? { ...rest, position } : rest;
  if (node.type === 'spot') return { ...rest, ...(position ? { position } : {}), direction: direction ?? [1, 2, 3] };
  if (node.type === 'cylinder') return { ...node, base: [1, 2, 0], top: [0, 1, -3] };
  if (node.type === 'cone') return { ...node, base: [1, 2, 0], tip: [0, 1, -3] };
  if (node.type === 'quad') return { ...node, edgeU: [1, 2, 0], edgeV: [0, 1, -3] };
  if (node.type === 'triangle') return { ...node, a: [-1, 0, 2], b: [4, 0, 0], c: [0, 7, 1] };
  if (node.type !== 'directional') return node.type === 'plane' || node.type === 'disc' ? { ...rest } : node;
  return direction ? { ...rest, direction } : rest;
}

/** A torus whose tube is thinner than its ring. */
function withinRing({ radius = 1, tube = 1, ...rest }: Json): Json {
  const [ring, thickness] = [Number(radius), Number(tube)];
  return { ...rest, radius: ring, tube: (0.9 * ring * thickness) / (ring + thickness) };
}

const shapes = variantOf(primitives, material.fields).map(consistent);

/** A shape, or a group with shapes, a light, and perhaps a group in it. */
const { object } = fc.letrec<{ object: Json; group: Json }>((tie) => ({
  object: fc.oneof({ maxDepth: 2, withCrossShrink: true }, { arbitrary: shapes, weight: 4 }, tie('group')),
  group: fc
    .tuple(
      nodeOf(group.fields),
      fc.array(tie('object'), { maxLength: 2 }),
      fc.array(variantOf(lights).map(consistent), { maxLength: 1 }),
    )
    .map(([fields, objects, inside]) => ({ type: 'group', ...fields, objects, lights: inside })),
}));

/** Of a scene in which all else is right: groups in groups may make lengths of it too small beside others. */
function lengthsFit(json: Json): boolean {
  try {
    return !!parseScene(json);
  } catch (error) {
    if (/1e13 times|1e12 times/.test(String(error))) return false;
    throw error;
  }
}

/** A valid scene file as plain JSON data. */
export const arbitraryScene: fc.Arbitrary<Json> = fc
  .record({
    camera: nodeOf({ fov: camera.fields.fov, position: camera.fields.position }),
    background: fc.constantFrom('transparent', 'environment', [0.1, 0.2, 0.3], 'navy'),
    environment: fc.constantFrom({ color: [0.5, 0.6, 0.7] }, { top: 'white', bottom: '#333', intensity: 2 }, undefined),
    lights: fc.array(variantOf(lights).map(consistent), { maxLength: 3 }),
    materials: fc.dictionary(fc.constantFrom('a', 'b', 'gold'), nodeOf(material.fields)),
    objects: fc.array(object, { maxLength: 5 }),
  })
  .map(({ environment, ...scene }) => ({ version: 1, ...(environment ? { environment } : {}), ...scene }))
  .filter(({ camera: { position } }) => !position || (position as number[]).some((x) => x !== 0))
  .filter(lengthsFit);
