/**
 * Every sentence that says what is wrong with a scene or a setting: what was found, what is allowed, and the nearest right
 * word. They all follow the words for where the problem is. A page loads them when something is wrong.
 */
import type { Limits } from './fields.ts';
import { nearestWord } from './nearest-word.ts';

/** A value as its author would recognise it, cut where it is long. */
function shown(value: unknown): string {
  const text =
    typeof value === 'number' || value === undefined ? String(value) : (JSON.stringify(value) ?? String(value));
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}

/** ` (did you mean "red"?)`, or nothing when no word is near. */
function suggestion(typed: unknown, words: Iterable<string>): string {
  const near = typeof typed === 'string' ? nearestWord(typed, words) : undefined;
  return near ? ` (did you mean "${near}"?)` : '';
}

const round = (length: number): string => String(Number(length.toPrecision(3)));

const article = (label: string): string => `${/^[aeiou]/.test(label) ? 'an' : 'a'} ${label}`;

const capitalized = (text: string): string => text[0]?.toUpperCase() + text.slice(1);

function range({ min, above, max }: Limits): string {
  const lower = above !== undefined ? ` above ${above}` : min !== undefined ? ` of at least ${min}` : '';
  const upper = max === undefined ? '' : `${lower ? ' and' : ' of'} at most ${max}`;
  return min !== undefined && max !== undefined ? ` from ${min} to ${max}` : lower + upper;
}

export const problemTexts = {
  // What a field takes, after its name:
  number: (limits: Limits) => `must be ${limits.integer ? 'a whole number' : 'a number'}${range(limits)}`,
  vector: ({ above, nonzero }: Limits) =>
    `must be three numbers "x y z"${above === undefined ? (nonzero ? ', not all 0' : '') : ` above ${above}`}`,
  factors: () => 'must be one number or three "x y z", each from 1e-12 to 1e12 or the negative of that',
  color: () => 'must be a colour like "crimson", "#8c3", "oklch(0.7 0.1 200)" or, in JSON, linear [r, g, b]',
  linearColor: ({ max }: Limits) => `must be three numbers from 0${max === undefined ? '' : ` to ${max}`}`,
  choice: (choices: readonly string[]) => `must be ${choices.map((word) => `"${word}"`).join(' or ')}`,
  name: (what: string) => `must be ${what}`,
  background: () => 'must be "environment", "transparent" or a colour',
  // What is wrong with a value, after that:
  suggestion,
  transparentColor: () => ', which has an alpha; use the opaque colour',
  strongColor: () => ', which is outside the sRGB gamut',
  field: (field: string, allowed: string, found: unknown, hint: string) =>
    `${field} ${allowed}, not ${shown(found)}${hint}`,
  // What is wrong with the whole:
  json: (why: string) => `is not JSON: ${why}`,
  newerVersion: (version: unknown) =>
    `version ${version} is newer than this ray-scene, which reads version 1: load a newer ray-scene`,
  version: (found: unknown) => `version must be 1, not ${shown(found)}`,
  text: (found: unknown) => `must be a text, not ${shown(found)}`,
  list: (found: unknown) => `must be a list [ … ], not ${shown(found)}`,
  node: (label: string, found: unknown) =>
    `must be ${label === 'materials' ? 'materials by name' : article(label)} { … }, not ${shown(found)}`,
  noType: (label: string, kinds: readonly string[]) => `has no type. Types of ${label}: ${kinds.join(', ')}.`,
  unknownType: (label: string, kinds: readonly string[], found: unknown) =>
    `unknown type ${shown(found)}${suggestion(found, kinds)}. Types of ${label}: ${kinds.join(', ')}.`,
  unknownField: (kind: string, typed: string, label: string, known: readonly string[]) =>
    `unknown ${kind} "${typed}"${suggestion(typed, known)}. ${capitalized(article(label))} takes: ${known.join(', ')}.`,
  unknownMaterial: (typed: string, known: readonly string[]) =>
    `unknown material "${typed}"${suggestion(typed, known)}. Materials here: ${known.join(', ')}.`,
  unknownSetting: (typed: string, known: readonly string[]) => `unknown setting "${typed}"${suggestion(typed, known)}`,
  tooMany: (limit: number, what: string, count: number) => `a scene may hold ${limit} ${what}, this one has ${count}`,
  tooDeep: (limit: number) => `groups may stand in each other ${limit} deep`,
  scales: () => 'scale, with that of the groups around it, must stay from 1e-12 to 1e12, and none 1e12 times another',
  farApart: (least: number, most: number, where: string) =>
    `has a length of ${round(least)}, and ${where} one of ${round(most)}: in one scene, none may be 1e13 times another`,
  // What does not fit together in a node:
  parallelTangent: () => 'tangent must not be parallel to the normal',
  noHeight: () => 'top must not be the base: the cylinder would have no height',
  flatCone: () => 'tip must not be in the base: the cone would have no height',
  parallelEdges: () => 'edges must not be parallel: the quad would have no area',
  cornersInLine: () => 'corners must not be in a line: there is no area',
  fatTorus: (tube: number, radius: number) =>
    `tube must be below the radius, not ${tube} for a radius of ${radius}: it would fill its own hole`,
  cameraToNowhere: () => 'target must not be the position: the camera would look nowhere',
  lightToNowhere: () => 'target must not be the position: the light would go nowhere',
  softWithoutDecay: () => 'decay must be 2 where there is a radius: a ball of light fades as light does',
  directionAndTarget: () => 'takes a direction or a target, not both',
  directionAndPosition: () => 'takes a direction, or a position and a target, not both',
  targetAlone: () => 'a target needs a position',
  imageAndColors: () => 'takes a src or colours, not both',
  colorAndGradient: () => 'takes a color, or top and bottom, not both',
  halfGradient: () => 'top and bottom belong together',
  // What only markup can have wrong:
  holdsElements: (tag: string) => `holds other elements, as <${tag}/> does in HTML: write <${tag}></${tag}>`,
  notInGroup: () => 'is of the whole scene: it cannot stand in a <ray-group>',
  saidAlready: (attribute: string, tag: string) => `unknown attribute "${attribute}": <${tag}> says it already`,
  another: (kind: string) => `a scene has one ${kind}, and this is another`,
  nameless: () => 'needs a name, for objects to refer to',
  sameName: (name: string) => `another material has the name "${name}"`,
  unknownElement: (tag: string, meant: string | undefined, tags: readonly string[]) =>
    `unknown element <${tag}>${meant ? ` (did you mean <${meant}>?)` : ''}. A ray-scene holds: ${tags
      .map((one) => `<${one}>`)
      .join(', ')}.`,
  severalScenes: (sources: readonly string[]) =>
    `has ${sources.length} scenes: ${sources.join(', ')}. Keep one of them.`,
} as const;

export type ProblemTexts = typeof problemTexts;
