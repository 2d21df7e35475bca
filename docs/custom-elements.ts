/**
 * The custom elements manifest, by which editors and documentation viewers know the elements: from the core's table of
 * fields, the elements' classes and the doc comments of `<ray-scene>`.
 */
import {
  camera,
  environment,
  type Fields,
  group,
  lights,
  material,
  type NodeTable,
  primitives,
  settingsFields,
} from '@ray-scene/core';
import type {
  Attribute,
  CustomElementDeclaration,
  CustomElementField,
  Export,
  JavaScriptModule,
  Package,
} from 'custom-elements-manifest/schema';
import { RayScene, sceneElements } from 'ray-scene/element';
import { attributeOf } from '../packages/ray-scene/src/field-properties.ts';
import { eventsOf, membersOf, tagsOf, textOfAll } from './doc-comments.ts';

const MODULE = 'dist/index.js';
const SOURCES = 'packages/ray-scene/src';

type AnyField = Fields[string];

/** The members of the manifest's own lists that all have a name and a description. */
interface Described {
  readonly name: string;
  readonly description: string;
}

const THREE = 'readonly [number, number, number]';

/** The type of the values of a field, as TypeScript has it. */
function typeOf({ kind, limits }: AnyField): string {
  if (kind === 'choice') {
    return (limits.choices ?? []).map((word) => (typeof word === 'number' ? word : `'${word}'`)).join(' | ');
  }
  return { number: 'number', vector: THREE, factors: THREE, color: THREE, name: 'string' }[kind];
}

/** A value as an attribute has it: `0 1 0`. */
const textOf = (value: unknown): string => (Array.isArray(value) ? value.join(' ') : String(value));

function fieldAttributes(fields: Fields): Attribute[] {
  return Object.entries(fields).map(([name, field]) => ({
    name: attributeOf(name),
    fieldName: name,
    description: field.doc,
    type: { text: field.kind === 'choice' || field.kind === 'number' ? typeOf(field) : 'string' },
    ...(field.default === undefined ? {} : { default: textOf(field.default) }),
  }));
}

function fieldMembers(fields: Fields): CustomElementField[] {
  return Object.entries(fields).map(([name, field]) => ({
    kind: 'field',
    name,
    description: field.doc,
    type: { text: field.default === undefined ? `${typeOf(field)} | undefined` : typeOf(field) },
    attribute: attributeOf(name),
    ...(field.default === undefined ? {} : { default: JSON.stringify(field.default) }),
    // Of what the table tells, only choices reflect; see `defineFieldProperties`.
    ...(field.kind === 'choice' ? { reflects: true } : {}),
  }));
}

/** `ray-sphere` as `RaySphere`. */
const classNameOf = (tag: string): string => tag.replace(/(?:^|-)(\w)/g, (_, letter: string) => letter.toUpperCase());

const lightTables = Object.entries(lights) as [kind: string, table: NodeTable][];

/** What the kinds say that differ, one after the other: `point, spot: Where it is. directional: …` */
function together(texts: readonly (readonly [kind: string, text: string])[]): string {
  const distinct = [...new Set(texts.map(([, text]) => text))];
  if (distinct.length === 1) return distinct[0] ?? '';
  const kindsOf = (doc: string) => texts.filter(([, text]) => text === doc).map(([kind]) => kind);
  return distinct.map((doc) => `${kindsOf(doc).join(', ')}: ${doc}`).join(' ');
}

/** The fields of all kinds of lights: an element can be any of them. */
function lightFields(fields: Fields): Fields {
  const merged = Object.entries(fields).map(([name, field]): [string, AnyField] => {
    const own = lightTables.flatMap(([kind, table]): [string, AnyField][] => {
      const found = table.fields[name];
      return found ? [[kind, found]] : [];
    });
    if (own.length === 0) return [name, field];
    const defaults = new Set(own.map(([, { default: value }]) => JSON.stringify(value)));
    const doc = together(own.map(([kind, { doc }]) => [kind, doc]));
    return [name, { ...field, doc, default: defaults.size > 1 ? undefined : field.default }];
  });
  return Object.fromEntries(merged);
}

const docs: { readonly [tag: string]: string } = {
  'ray-camera': camera.doc,
  'ray-environment': environment.doc,
  'ray-group': group.doc,
  'ray-light': together(lightTables.map(([kind, { doc }]) => [kind, doc])),
  'ray-material': material.doc,
  ...Object.fromEntries(Object.entries(primitives).map(([kind, { doc }]) => [`ray-${kind}`, doc])),
};

const sceneDeclarations = (): CustomElementDeclaration[] =>
  Object.entries(sceneElements).map(([tag, { kind, fields: all }]) => {
    const fields = kind === 'light' ? lightFields(all) : all;
    return {
      kind: 'class',
      customElement: true,
      name: classNameOf(tag),
      tagName: tag,
      description: docs[tag] ?? '',
      superclass: { name: 'SceneElement', module: MODULE },
      attributes: fieldAttributes(fields),
      members: fieldMembers(fields),
    };
  });

/** What CSS takes where an author sets none of these properties. */
const cssDefault = (name: string): { default?: string } => {
  const [, value] = new RegExp(`var\\(${name}, ((?:[^()]|\\([^()]*\\))*)\\)`).exec(textOfAll(SOURCES)) ?? [];
  return value === undefined ? {} : { default: value };
};

const described = ({ name, description }: Described): Described => ({ name, description });

/** `<ray-scene>` itself: lit's properties, and those of the table. */
function rayScene(): CustomElementDeclaration {
  const source = `${SOURCES}/ray-scene.ts`;
  const { description, tags } = tagsOf(source, 'RayScene');
  const settings = membersOf(`${SOURCES}/settings-element.ts`, 'LitSettingsElement');
  const members = [...membersOf(source, 'RayScene'), ...settings.filter(({ name }) => name === 'settings')];
  const own = Object.entries(RayScene.properties).map(([name, { attribute, reflect }]) => ({
    name,
    // As lit spells those that say nothing else.
    attribute: typeof attribute === 'string' ? attribute : name.toLowerCase(),
    reflect,
  }));
  return {
    kind: 'class',
    customElement: true,
    name: 'RayScene',
    tagName: 'ray-scene',
    description,
    superclass: { name: 'ReactiveElement', package: '@lit/reactive-element' },
    attributes: [
      ...own.map(({ name, attribute }) => ({ name: attribute, fieldName: name, ...docOf(members, name) })),
      ...fieldAttributes(settingsFields),
    ],
    members: [
      ...members.map((member) => {
        const { attribute, reflect } = own.find(({ name }) => name === member.name) ?? {};
        return { ...member, ...(attribute && { attribute }), ...(reflect && { reflects: true }) };
      }),
      ...fieldMembers(settingsFields),
    ],
    events: eventsOf(`${SOURCES}/events.ts`),
    slots: tags('slot').map(described),
    cssParts: tags('csspart').map(described),
    cssProperties: tags('cssprop').map((tag) => ({ ...described(tag), ...cssDefault(tag.name) })),
  };
}

function docOf(members: ReturnType<typeof membersOf>, name: string): Partial<Attribute> {
  const { description, type } = members.find((member) => member.name === name) ?? {};
  // No attribute is null: it is not there.
  return { ...(description && { description }), ...(type && { type: { text: type.text.replace(' | null', '') } }) };
}

/** By the schema of the web components community group. */
export function customElementsManifest(): Package {
  const declarations = [rayScene(), ...sceneDeclarations()];
  const definitions = declarations.map(
    ({ name, tagName = '' }): Export => ({
      kind: 'custom-element-definition',
      name: tagName,
      declaration: { name, module: MODULE },
    }),
  );
  const module: JavaScriptModule = {
    kind: 'javascript-module',
    path: MODULE,
    description: 'Registers all elements.',
    declarations,
    exports: [{ kind: 'js', name: 'RayScene', declaration: { name: 'RayScene', module: MODULE } }, ...definitions],
  };
  return { schemaVersion: '2.1.0', modules: [module] };
}
