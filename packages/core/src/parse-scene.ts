/** Scenes from strangers: JSON text, plain objects or what markup was read into, all through one validator. */
import { contradiction } from './contradictions.ts';
import { color, type Fields, Mismatch } from './fields.ts';
import { knownMaterials } from './named-materials.ts';
import { primitives } from './primitives/index.ts';
import { lengthProblems, say } from './say.ts';
import { jsonPath, type Locate, type Problem, SceneError } from './scene-error.ts';
import {
  type Background,
  camera,
  environment,
  group,
  lights,
  material,
  type NodeTable,
  objectFields,
  type Scene,
} from './schema.ts';

/** How a source words things: where a path is, and how a field is spelt there. */
export interface SourceWords {
  readonly locate: Locate;
  /** `key` or `attribute`. */
  readonly field: string;
  readonly spell: (field: string) => string;
}

const jsonWords: SourceWords = { locate: jsonPath, field: 'key', spell: (field) => field };

/** How much a scene may hold, in groups too, which count as objects; and how deep groups may stand in each other. */
export const limits = { objects: 1024, lights: 64, materials: 1024, depth: 16 } as const;

/**
 * Numbers from a million on or below 0.00001, or groups that scale. Without any, no length can be too many times another; with
 * them, what is loaded to tell is worth its while.
 */
const UNUSUAL = /(?<!\.\d*)\d{7}|\b0\.0{5}|\de|le":.(?!1,1,1])/;

const backgroundColor = color('What a camera ray shows that meets no object.');

const rootKeys = [
  'version',
  'name',
  'camera',
  'environment',
  'background',
  'lights',
  'materials',
  'objects',
  'extras',
  '$schema',
];

/**
 * Validates a scene: a JSON text, or a plain object in which any value may also be the text it has in markup.
 * Returns a deeply frozen scene with all defaults of its nodes filled in.
 * @throws {SceneError} with every problem at once.
 */
export function parseScene(input: unknown, words: SourceWords = jsonWords): Scene {
  const parser = new SceneParser(words);
  const scene = parser.scene(typeof input === 'string' ? parser.json(input) : input);
  if (!scene || parser.problems.length > 0) throw new SceneError(parser.problems);
  return deepFreeze(scene);
}

type Path = Problem['path'];
type Raw = { readonly [key: string]: unknown };

class SceneParser {
  readonly problems: Problem[] = [];
  readonly #words: SourceWords;
  readonly #counts = { lights: 0, objects: 0 };

  constructor(words: SourceWords) {
    this.#words = words;
  }

  json(text: string): unknown {
    try {
      return JSON.parse(text);
    } catch (error) {
      this.#report([], say('json', (error as Error).message));
      return undefined;
    }
  }

  scene(input: unknown): Scene | undefined {
    if (this.problems.length > 0) return undefined;
    const root = this.#object([], input, 'scene');
    if (!root || !this.#version(root)) return undefined;
    this.#unknownKeys([], root, rootKeys, 'scene');
    const scene = {
      version: 1 as const,
      ...this.#optional('name', root, (path, value) => this.#text(path, value)),
      ...this.#optional('camera', root, (path, value) => this.#node(path, value, camera, 'camera')),
      ...this.#optional('environment', root, (path, value) => this.#node(path, value, environment, 'environment')),
      ...this.#optional('background', root, (path, value) => this.#background(path, value)),
      lights: this.#list([], root, 'lights'),
      materials: this.#materials(root.materials),
      objects: this.#list([], root, 'objects'),
      ...(root.extras === undefined ? {} : { extras: structuredCloneOf(root.extras) }),
    } as Scene;
    this.#limit(['lights'], this.#counts.lights, 'lights');
    this.#limit(['objects'], this.#counts.objects, 'objects');
    this.#tree([], scene.objects, [...Object.keys(scene.materials), ...Object.keys(knownMaterials())]);
    if (scene.objects[0] && UNUSUAL.test(JSON.stringify([scene.camera, scene.lights, scene.objects]))) {
      this.problems.push(...lengthProblems(scene, this.#words.locate, this.problems));
    }
    return scene;
  }

  /** A newer file gets one clear message rather than one per key it uses. */
  #version({ version = 1 }: Raw): boolean {
    if (String(version) === '1') return true;
    const newer = Number(version) > 1;
    this.#report(['version'], newer ? say('newerVersion', version) : say('version', version), []);
    return false;
  }

  #node(path: Path, input: unknown, table: NodeTable, label: string, given = false): object | undefined {
    const raw = this.#object(path, input, label);
    if (!raw) return undefined;
    const { fields, holds = [] } = table;
    this.#unknownKeys(path, raw, [...Object.keys(fields), ...holds], label);
    const values = {
      ...this.#values(path, raw, fields, given),
      ...Object.fromEntries(holds.map((list) => [list, this.#list(path, raw, list)])),
    };
    for (const message of contradiction(label, values)) this.#report(path, message);
    return values;
  }

  /** Reads the fields that are there; fills in defaults unless only the `given` ones are wanted. */
  #values(path: Path, raw: Raw, fields: Fields, given: boolean): Raw {
    const values: { [name: string]: unknown } = {};
    for (const [name, field] of Object.entries(fields)) {
      const value = raw[name];
      const read = value === undefined ? (given ? undefined : field.default) : field.read(value);
      if (read instanceof Mismatch) {
        this.#report([...path, name], read.sentence(this.#words.spell(name), value), path);
      } else if (read !== undefined) values[name] = read;
    }
    return values;
  }

  #variant(path: Path, input: unknown, tables: { [kind: string]: NodeTable }, label: string): object | undefined {
    const raw = this.#object(path, input, label);
    if (!raw) return undefined;
    const { type: kind = label === 'light' ? 'point' : undefined, ...rest } = raw;
    const table = typeof kind === 'string' && Object.hasOwn(tables, kind) ? tables[kind] : undefined;
    if (!table) {
      const kinds = Object.keys(tables);
      const message = kind === undefined ? say('noType', label, kinds) : say('unknownType', label, kinds, kind);
      this.#report([...path, 'type'], message, path);
      return undefined;
    }
    const name = label === 'light' ? `${kind} light` : String(kind);
    const values = this.#node(path, rest, table, name);
    return values && { type: kind, ...values };
  }

  #sceneObject(path: Path, input: unknown): object | undefined {
    const raw = this.#object(path, input, 'object');
    if (!raw) return undefined;
    const own: { [name: string]: unknown } = {};
    const shape: { [name: string]: unknown } = {};
    const kind = primitives[raw.type as keyof typeof primitives];
    for (const [key, value] of Object.entries(raw)) {
      (kind && !(key in kind.fields) && (key in objectFields || key in material.fields) ? own : shape)[key] = value;
    }
    const common = this.#values(path, own, objectFields, true);
    const surface = this.#values(path, own, material.fields, true);
    const values = this.#variant(path, shape, objectTables, 'object');
    return values && { ...values, ...common, ...surface };
  }

  #materials(input: unknown): Scene['materials'] {
    if (input === undefined) return {};
    const raw = this.#object(['materials'], input, 'materials') ?? {};
    this.#limit(['materials'], Object.keys(raw).length, 'materials');
    return Object.fromEntries(
      Object.entries(raw).map(([name, value]) => [
        name,
        this.#node(['materials', name], value, material, 'material', true) ?? {},
      ]),
    );
  }

  /** What only a node's place tells: whether there is its material. */
  #tree(above: Path, nodes: Scene['objects'], materials: readonly string[]): void {
    nodes.forEach((node, i) => {
      const path = [...above, 'objects', i];
      if (node?.type === 'group') this.#tree(path, node.objects, materials);
      else if (node?.material !== undefined && !materials.includes(node.material)) {
        const known = [...new Set(materials)];
        this.#report([...path, 'material'], say('unknownMaterial', node.material, known), path);
      }
    });
  }

  #background(path: Path, value: unknown): Background | undefined {
    if (value === 'environment' || value === 'transparent') return value;
    const read = backgroundColor.read(value);
    if (!(read instanceof Mismatch)) return read;
    const problem = new Mismatch(() => say('background'), read.hint);
    this.#report(path, problem.sentence('background', value), []);
    return undefined;
  }

  #text(path: Path, value: unknown): string | undefined {
    if (typeof value === 'string') return value;
    this.#report(path, say('text', value));
    return undefined;
  }

  #list(above: Path, raw: Raw, key: 'lights' | 'objects'): unknown[] {
    const list = raw[key] ?? [];
    const path = [...above, key];
    if (!Array.isArray(list)) {
      this.#report(path, say('list', list), above.length > 0 ? above : path);
      return [];
    }
    if (above.length > 2 * limits.depth) {
      if (key === 'objects') this.#report(above, say('tooDeep', limits.depth));
      return [];
    }
    const room = Math.max(limits[key] - this.#counts[key], 0);
    this.#counts[key] += list.length;
    return list
      .slice(0, room)
      .map((value, i) =>
        key === 'lights' ? this.#variant([...path, i], value, lights, 'light') : this.#sceneObject([...path, i], value),
      );
  }

  #limit(path: Path, count: number, key: 'lights' | 'objects' | 'materials'): void {
    if (count > limits[key]) this.#report(path, say('tooMany', limits[key], key, count));
  }

  #optional<K extends string, T>(key: K, root: Raw, read: (path: Path, value: unknown) => T | undefined) {
    const value = root[key] === undefined ? undefined : read([key], root[key]);
    return (value === undefined ? {} : { [key]: value }) as { [P in K]?: T };
  }

  #object(path: Path, value: unknown, label: string): Raw | undefined {
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Raw;
    this.#report(path, say('node', label, value));
    return undefined;
  }

  #unknownKeys(path: Path, raw: Raw, known: readonly string[], label: string): void {
    const { field, spell } = this.#words;
    const listed = Object.hasOwn(primitives, label)
      ? [...known, ...Object.keys(objectFields), ...Object.keys(material.fields)]
      : known;
    // In markup, what a node holds are not attributes.
    const words = listed.filter((key) => field === 'key' || (key !== 'lights' && key !== 'objects')).map(spell);
    for (const key of Object.keys(raw)) {
      if (listed.includes(key)) continue;
      this.#report([...path, key], say('unknownField', field, spell(key), label, words), path);
    }
  }

  #report(path: Path, message: string, at = path): void {
    this.problems.push({ path, where: this.#words.locate(at), message });
  }
}

const objectTables: { readonly [kind: string]: NodeTable } = { ...primitives, group };

const structuredCloneOf = (value: unknown): unknown => JSON.parse(JSON.stringify(value));

function deepFreeze<T>(value: T): T {
  if (typeof value === 'object' && value !== null) Object.values(Object.freeze(value)).forEach(deepFreeze);
  return value;
}
