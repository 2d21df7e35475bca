/** The child elements of a `<ray-scene>` as the plain object that they describe, for `parseScene` to judge. */
import { meantWord, type Problem, type SourceWords, say } from '@ray-scene/core';
import { attributeOf, fieldOf } from './field-properties.ts';
import { SceneElement, sceneElements } from './scene-elements.ts';

/** What markup says. */
export interface Markup {
  readonly input: object;
  /** How `parseScene` tells where a problem is. */
  readonly words: SourceWords;
  /** What is wrong with the elements themselves. */
  readonly problems: readonly Problem[];
  /** The element that a node was read from. */
  elementOf(path: Problem['path']): Element | undefined;
}

/** Whether a child of `<ray-scene>` is meant to be a part of the scene; anything else is content for people. */
export function isSceneMarkup(element: Element): boolean {
  const { localName } = element;
  return (
    element instanceof SceneElement ||
    localName.startsWith('ray-') ||
    element instanceof HTMLUnknownElement ||
    (/^r\w*-/.test(localName) && !customElements.get(localName) && nearestTag(localName) !== undefined)
  );
}

export const readMarkup = (scene: Element): Markup => new MarkupReader(scene);

/** `ray-scene > ray-sphere[2]`: the index counts from 1 among siblings of the same tag, if there are several. */
function place(scene: Element, element: Element): string {
  const { localName, parentElement } = element;
  if (element === scene || !parentElement) return localName;
  const alike = [...parentElement.children].filter((sibling) => sibling.localName === localName);
  const index = alike.length > 1 ? `[${alike.indexOf(element) + 1}]` : '';
  return `${place(scene, parentElement)} > ${localName}${index}`;
}

/** What every element may have, and what frameworks leave on any element, as Vue's `v-…` and Alpine's `@…`. */
const ANYWHERE =
  /^(?:id|class|style|slot|part|exportparts|title|lang|dir|hidden|inert|tabindex|role|is|item[a-z]+|nonce|draggable|translate|popover|autofocus|accesskey|contenteditable|spellcheck|xmlns|[^a-z].*|[a-z]{1,2}[-:].*|(?:aria|data|defer)-.*|on.*)$/;

/** The attributes of an element of ours that mean nothing on it. */
export function unknownAttributes(element: Element): string[] {
  const { observedAttributes } = element.constructor as typeof SceneElement;
  return element.getAttributeNames().filter((name) => !observedAttributes.includes(name) && !ANYWHERE.test(name));
}

const tags = Object.keys(sceneElements);

/** The tag that was meant; people also write a node's name without its prefix. */
function nearestTag(typed: string): string | undefined {
  const near = meantWord(typed, [...tags, ...tags.map((tag) => tag.slice(4))]);
  return near && (tags.includes(near) ? near : `ray-${near}`);
}

/** The scene or a group in it: where it is, and what it holds. */
interface MarkupGroup {
  readonly path: Problem['path'];
  readonly lights: object[];
  readonly objects: object[];
}

class MarkupReader implements Markup {
  readonly problems: Problem[] = [];
  readonly words: SourceWords = {
    locate: (path) => place(this.#scene, this.elementOf(path) ?? this.#scene),
    field: 'attribute',
    spell: attributeOf,
  };
  readonly #scene: Element;
  /** By the path of a node, the element that it was read from. */
  readonly #elements = new Map<string, Element>();
  readonly #singles: { camera?: object; environment?: object } = {};
  readonly #root: MarkupGroup = { path: [], lights: [], objects: [] };
  readonly #materials = new Map<string, object>();

  constructor(scene: Element) {
    this.#scene = scene;
    for (const child of scene.children) this.#read(child);
  }

  elementOf(path: Problem['path']): Element | undefined {
    return path.length > 0 ? (this.#elements.get(path.join('/')) ?? this.elementOf(path.slice(0, -1))) : undefined;
  }

  get input(): object {
    const { lights, objects } = this.#root;
    return { ...this.#singles, lights, objects, materials: Object.fromEntries(this.#materials) };
  }

  #read(element: Element, group = this.#root): void {
    if (!isSceneMarkup(element)) return;
    let inside = group;
    if (element instanceof SceneElement) inside = this.#node(element, group);
    else this.#unknown(element);
    // What stands inside of anything but a group was meant to stand beside: what else is wrong with it is told too.
    for (const child of element.children) this.#read(child, inside);
  }

  /** Returns the group that the element's children are in. */
  #node(element: SceneElement, group: MarkupGroup): MarkupGroup {
    const { kind, localName: tag } = element;
    const isGroup = kind === 'group';
    const raw = { ...strangers(element), ...element.given };
    if (element.childElementCount > 0 && !isGroup) {
      this.#report(element, say('holdsElements', tag));
    }
    if (kind === 'light') this.#item('lights', element, raw, group);
    else if (kind === 'camera' || kind === 'environment' || kind === 'material') {
      if (group !== this.#root) this.#report(element, say('notInGroup'));
      if (kind === 'material') this.#material(element, raw);
      else this.#single(kind, element, raw);
    } else {
      for (const said of isGroup ? ['type', 'lights', 'objects'] : ['type']) {
        if (said in raw) this.#report(element, say('saidAlready', said, tag));
      }
      const lists = { lights: [], objects: [] };
      const path = this.#item('objects', element, { ...raw, ...(isGroup && lists), type: kind }, group);
      if (isGroup) return { path, ...lists };
    }
    return group;
  }

  #single(kind: 'camera' | 'environment', element: Element, raw: object): void {
    if (this.#singles[kind]) this.#report(element, say('another', kind));
    this.#singles[kind] = raw;
    this.#elements.set(kind, element);
  }

  /** Returns its path. */
  #item(list: 'lights' | 'objects', element: Element, raw: object, group: MarkupGroup): Problem['path'] {
    const path = [...group.path, list, group[list].push(raw) - 1];
    this.#elements.set(path.join('/'), element);
    return path;
  }

  #material(element: Element, { name, ...raw }: { readonly [field: string]: unknown }): void {
    if (typeof name !== 'string' || !name.trim()) this.#report(element, say('nameless'));
    else if (this.#materials.has(name)) this.#report(element, say('sameName', name));
    this.#materials.set(String(name), raw);
    this.#elements.set(`materials/${name}`, element);
  }

  #unknown(element: Element): void {
    const { localName } = element;
    this.#report(element, say('unknownElement', localName, nearestTag(localName), tags));
  }

  #report(element: Element, message: string): void {
    this.problems.push({ path: [], where: place(this.#scene, element), message });
  }
}

/** Attributes that mean nothing, for `parseScene` to complain about. */
const strangers = (element: SceneElement): { readonly [field: string]: unknown } =>
  Object.fromEntries(unknownAttributes(element).map((name) => [fieldOf(name), element.getAttribute(name)]));
