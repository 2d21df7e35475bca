/** `<ray-camera>`, `<ray-sphere>` and the others: an element for every node of the core's table. */
import {
  camera,
  environment,
  type Field,
  type Fields,
  group,
  type LightKind,
  lightKinds,
  lights,
  lightType,
  material,
  type NodeTable,
  objectFields,
  primitives,
  type ShapeKind,
  shapeKinds,
} from '@ray-scene/core';
import {
  adoptEarlyProperties,
  attributeOf,
  defineFieldProperties,
  type FieldHost,
  fieldOf,
  give,
} from './field-properties.ts';

// Where there is no DOM, as on a server, the classes can still be imported.
const HTMLElementOrNot = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** What a scene element stands for. */
export type NodeKind = 'camera' | 'light' | 'environment' | 'material' | 'group' | ShapeKind;

/** Who wants to know that a property of a scene element below it was set. */
export interface SceneHost {
  markupChanged(): void;
}

/** A node of the scene in markup. Its properties are the truth; its attributes are ways to set them. */
export class SceneElement extends HTMLElementOrNot implements FieldHost {
  static readonly kind: NodeKind;
  static readonly fields: Fields = {};

  static readonly observedAttributes: readonly string[] = [];

  readonly given: { [field: string]: unknown } = {};

  get kind(): NodeKind {
    return (this.constructor as typeof SceneElement).kind;
  }

  get fields(): Fields {
    return (this.constructor as typeof SceneElement).fields;
  }

  connectedCallback(): void {
    adoptEarlyProperties(this, Object.keys(this.fields));
  }

  attributeChangedCallback(attribute: string, _before: string | null, text: string | null): void {
    give(this, fieldOf(attribute), text);
  }

  fieldChanged(): void {
    let above: (Partial<SceneHost> & Element) | null = this.parentElement;
    while (above && !above.markupChanged) above = above.parentElement;
    above?.markupChanged?.();
  }
}

type PropertiesOf<F> = { -readonly [K in keyof F]: F[K] extends Field<infer T> ? T : never };
type KeyOfAny<U> = U extends unknown ? keyof U : never;
type ValueInAny<U, K extends PropertyKey> = U extends { readonly [P in K]: Field<infer T> } ? T : never;

type LightFields = { [K in LightKind]: (typeof lights)[K]['fields'] }[LightKind];

/** By the name of a node, the properties of its element. */
type NodeProperties = {
  camera: PropertiesOf<typeof camera.fields>;
  light: { type: LightKind } & { [K in KeyOfAny<LightFields>]: ValueInAny<LightFields, K> | undefined };
  environment: PropertiesOf<typeof environment.fields>;
  material: { name: string | undefined } & Partial<PropertiesOf<typeof material.fields>>;
  group: PropertiesOf<typeof group.fields>;
} & {
  [K in ShapeKind]: PropertiesOf<(typeof primitives)[K]['fields'] & typeof objectFields> &
    Partial<PropertiesOf<typeof material.fields>>;
};

/** By tag, the properties of every scene element. */
export type SceneElementProperties = { [K in NodeKind as `ray-${K}`]: NodeProperties[K] };

/** By tag, every scene element. */
export type SceneElementTagNameMap = {
  [Tag in keyof SceneElementProperties]: SceneElement & SceneElementProperties[Tag];
};

/** A field whose absence means that something else decides. */
const open = (fields: Fields): Fields =>
  Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, { ...field, default: undefined }]));

const surfaceFields = open(material.fields);
const anyLight: Fields = Object.assign({ type: lightType }, ...lightKinds.map((kind) => lights[kind].fields));

/** Which fields a light has is a matter of its type. */
class LightElement extends SceneElement {
  override get fields(): Fields {
    const { type } = this.given;
    return {
      ...anyLight,
      ...(lights as { [kind: string]: NodeTable })[(type as LightKind | undefined) ?? 'point']?.fields,
    };
  }
}

function elementOf(kind: NodeKind, fields: Fields, Base = SceneElement): typeof SceneElement {
  class NodeElement extends Base {
    static override readonly kind = kind;
    static override readonly fields = fields;
    static override readonly observedAttributes = Object.keys(fields).map(attributeOf);
  }
  defineFieldProperties(NodeElement, fields);
  return NodeElement;
}

const classes: readonly (typeof SceneElement)[] = [
  elementOf('camera', camera.fields),
  elementOf('light', anyLight, LightElement),
  elementOf('environment', environment.fields),
  elementOf('group', group.fields),
  elementOf('material', { name: objectFields.name, ...surfaceFields }),
  ...shapeKinds.map((kind) => elementOf(kind, { ...primitives[kind].fields, ...objectFields, ...surfaceFields })),
];

/** By tag, the class of every scene element. */
export const sceneElements = Object.fromEntries(classes.map((element) => [`ray-${element.kind}`, element])) as {
  readonly [Tag in keyof SceneElementTagNameMap]: Omit<typeof SceneElement, 'prototype'> &
    (new () => SceneElementTagNameMap[Tag]);
};
