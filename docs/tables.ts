/** The tables of the documentation, made from the core's table of fields. See test/unit/docs.test.ts. */
import {
  builtInMaterials,
  camera,
  environment,
  type Fields,
  group,
  lights,
  type Mismatch,
  material,
  type NodeTable,
  objectFields,
  primitives,
  settingsFields,
} from '@ray-scene/core';

type AnyField = Fields[string];

/** `from 0 to 1`, `above 0` */
function range({ min, above, max }: AnyField['limits']): string {
  if (above !== undefined) return ` above ${above}${max === undefined ? '' : `, at most ${max}`}`;
  if (min === undefined) return max === undefined ? '' : ` of at most ${max}`;
  return max === undefined ? ` of at least ${min}` : ` from ${min} to ${max}`;
}

function valuesOf({ kind, limits, read }: AnyField): string {
  switch (kind) {
    case 'number':
      return `${limits.integer ? 'whole number' : 'number'}${range(limits)}`;
    case 'vector':
      return 'x y z';
    case 'factors':
      return 'x y z, or one number';
    case 'color':
      return 'colour';
    case 'choice':
      return (limits.choices ?? []).map((word) => `\`${word}\``).join(', ');
    default:
      // A name or an address, as whoever leaves it empty is told.
      return /\w+$/.exec((read('') as Mismatch).allowed())?.[0] ?? kind;
  }
}

function defaultOf({ kind, default: value }: AnyField): string {
  if (value === undefined) return '';
  if (kind === 'color') return String(value) === '1,1,1' ? 'white' : 'black';
  return Array.isArray(value) ? value.join(' ') : String(value);
}

/** `checkerSize` as `checker-size`. */
const kebab = (name: string): string => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** A Markdown table of rows of cells. */
const table = (head: readonly string[], rows: readonly (readonly string[])[]): string =>
  [head, head.map(() => '---'), ...rows].map((cells) => `| ${cells.join(' | ')} |`).join('\n');

const fieldTable = (fields: Fields, head: string): string =>
  table(
    [head, 'value', 'default', 'meaning'],
    Object.entries(fields).map(([name, field]) => [
      `\`${kebab(name)}\``,
      valuesOf(field),
      defaultOf(field),
      field.doc.replaceAll('|', '\\|'),
    ]),
  );

const section = (title: string, { doc, fields }: NodeTable): string =>
  `## ${title}\n\n${doc}\n\n${fieldTable(fields, 'attribute')}`;

/** Of the attributes of `<ray-scene>` that say how to render. */
export const settingsTable = (): string => fieldTable(settingsFields, 'attribute');

/** Of every node of a scene and of the built-in materials. */
export function sceneTables(): string {
  return [
    section('`<ray-camera>`, `camera`', camera),
    ...Object.entries(lights).map(([kind, node]) => section(`\`<ray-light type="${kind}">\`, \`lights\``, node)),
    section('`<ray-environment>`, `environment`', environment),
    section('`<ray-material>`, `materials`', material),
    ...Object.entries(primitives).map(([kind, node]) => section(`\`<ray-${kind}>\`, \`objects\``, node)),
    section('`<ray-group>`, `objects`', group),
    section('On every object', {
      doc: 'An object also takes every field of a material for itself; they go before those of the material it names.',
      fields: objectFields,
    }),
    `## Built-in materials\n\n${table(
      ['name', 'fields'],
      Object.entries(builtInMaterials).map(([name, fields]) => [
        `\`${name}\``,
        Object.entries(fields)
          .map(([field, value]) => `${kebab(field)} ${Array.isArray(value) ? `[${value.join(', ')}]` : value}`)
          .join(', '),
      ]),
    )}`,
  ].join('\n\n');
}
