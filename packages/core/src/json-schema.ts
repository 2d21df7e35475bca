/** The JSON Schema of scene files, from the same table as the parser: for editors and for other validators. */
import { type Field, type Fields, LARGEST_FACTOR, LARGEST_LENGTH } from './fields.ts';
import { limits } from './parse-scene.ts';
import { primitives } from './primitives/index.ts';
import { camera, environment, group, lights, material, type NodeTable, objectFields } from './schema.ts';

/** A JSON Schema (draft 2020-12) as plain data. */
export type JsonSchema = { readonly [keyword: string]: unknown };

/**
 * The schema of what `parseScene` reads, draft 2020-12. It knows the JSON form of every value; the parser also takes
 * the text that a value has in markup, and checks what a schema cannot: colour names, names of materials, and fields
 * that contradict each other.
 */
export function sceneJsonSchema(): JsonSchema {
  return {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    title: 'ray-scene',
    description: 'A scene for <ray-scene>.',
    ...object({
      $schema: { type: 'string' },
      version: { const: 1 },
      name: { type: 'string' },
      camera: node(camera),
      environment: node(environment),
      background: {
        description: 'What a camera ray shows that meets no object.',
        anyOf: [{ enum: ['environment', 'transparent'] }, colorSchema({ max: 1 })],
      },
      lights: lists.lights,
      materials: { type: 'object', maxProperties: limits.materials, additionalProperties: node(material) },
      objects: lists.objects,
      extras: { description: "The author's own data, never read." },
    }),
    $defs: {
      lights: list(
        Object.entries(lights).map(([kind, table]) => variant(kind, table, kind !== 'point')),
        limits.lights,
      ),
      objects: list(
        [
          ...Object.entries(primitives).map(([kind, table]) =>
            variant(kind, { ...table, fields: { ...table.fields, ...objectFields, ...material.fields } }, true),
          ),
          variant('group', group, true),
        ],
        limits.objects,
      ),
    },
  };
}

/** A group holds lists of the same kinds as the scene. */
const lists = { lights: { $ref: '#/$defs/lights' }, objects: { $ref: '#/$defs/objects' } } as const;

const object = (properties: { readonly [name: string]: JsonSchema }, required: readonly string[] = []): JsonSchema => ({
  type: 'object',
  properties,
  required,
  additionalProperties: false,
});

const fieldSchemas = (fields: Fields): { readonly [name: string]: JsonSchema } =>
  Object.fromEntries(
    Object.entries(fields).map(([name, { doc, kind, limits, default: value }]) => [
      name,
      { description: doc, ...valueSchemas[kind](limits), ...(value === undefined ? {} : { default: value }) },
    ]),
  );

type Limits = Field<unknown>['limits'];

const triple = (items: JsonSchema): JsonSchema => ({ type: 'array', minItems: 3, maxItems: 3, items });

const colorSchema = ({ max = LARGEST_LENGTH }: Limits): JsonSchema => ({
  anyOf: [triple({ type: 'number', minimum: 0, maximum: max }), { type: 'string', minLength: 3 }],
});

const valueSchemas: { readonly [K in Field<unknown>['kind']]: (limits: Limits) => JsonSchema } = {
  number: ({ min = -LARGEST_LENGTH, above, max = LARGEST_LENGTH, integer }) => ({
    type: integer ? 'integer' : 'number',
    ...(above === undefined ? { minimum: min } : { exclusiveMinimum: above }),
    maximum: max,
  }),
  vector: ({ nonzero, above }) => ({
    ...triple({
      type: 'number',
      ...(above === undefined ? { minimum: -LARGEST_LENGTH } : { exclusiveMinimum: above }),
      maximum: LARGEST_LENGTH,
    }),
    ...(nonzero ? { contains: { not: { const: 0 } } } : {}),
  }),
  factors: ({ max = LARGEST_FACTOR }) => {
    const factor = { anyOf: [1, -1].map((sign) => between(sign / max, sign * max)) };
    return { anyOf: [factor, triple(factor)] };
  },
  color: colorSchema,
  choice: ({ choices }) => ({ enum: choices }),
  name: () => ({ type: 'string', pattern: '\\S' }),
};

const between = (a: number, b: number): JsonSchema => ({
  type: 'number',
  minimum: Math.min(a, b),
  maximum: Math.max(a, b),
});

const node = ({ doc, fields }: NodeTable): JsonSchema => ({ description: doc, ...object(fieldSchemas(fields)) });

/** A node that says its kind by `type`; the first kind of light need not. */
const variant = (kind: string, { doc, fields, holds = [] }: NodeTable, named: boolean): JsonSchema => ({
  description: doc,
  ...object(
    {
      type: { const: kind },
      ...fieldSchemas(fields),
      ...Object.fromEntries(holds.map((key) => [key, lists[key]])),
    },
    named ? ['type'] : [],
  ),
});

const list = (variants: readonly JsonSchema[], maxItems: number): JsonSchema => ({
  type: 'array',
  maxItems,
  items: { oneOf: variants },
});
