/** Kinds of fields: how each is read from JSON or from the text of an attribute, and how its JSON Schema looks. */
import { colorNames, readColor } from './color.ts';
import { nearestWord } from './nearest-word.ts';
import type { Vec3 } from './vector.ts';

/** What a field accepts, as data: for the JSON Schema, the docs and tools. */
export interface Limits {
  readonly min?: number | undefined;
  /** Exclusive lower bound. */
  readonly above?: number | undefined;
  readonly max?: number | undefined;
  readonly integer?: boolean | undefined;
  /** Not all components 0. */
  readonly nonzero?: boolean | undefined;
  readonly choices?: readonly (string | number)[];
}

/** What a value should have been: `must be a number above 0`. Returned instead of a value that cannot be read. */
export class Mismatch {
  readonly message: string;
  /** What to say after the value that was found: ` (did you mean "red"?)`. */
  readonly hint: string;

  constructor(message: string, hint = '') {
    this.message = message;
    this.hint = hint;
  }

  /** The whole sentence, for a field as it is spelt and the value that was found. */
  sentence(field: string, found: unknown): string {
    return `${field} ${this.message}, not ${shown(found)}${this.hint}`;
  }
}

/** A value as its author would recognise it, cut where it is long. */
export function shown(value: unknown): string {
  const text =
    typeof value === 'number' || value === undefined ? String(value) : (JSON.stringify(value) ?? String(value));
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}

/** ` (did you mean "red"?)`, or nothing when no word is near. */
export function suggestion(typed: unknown, words: Iterable<string>): string {
  const near = typeof typed === 'string' ? nearestWord(typed, words) : undefined;
  return near ? ` (did you mean "${near}"?)` : '';
}

/** By the name of a shader feature: whether a value needs it. */
export type Switches<T> = { readonly [feature: string]: (value: T) => boolean };

/** One field of a scene node. T includes undefined where the field has no default. */
export interface Field<T> {
  /** One line: what it means, with its unit. */
  readonly doc: string;
  readonly default: T;
  /** The shader features that a value needs. */
  features(value: NonNullable<T>): readonly string[];
  /** The kind of value, for people and for tools. */
  readonly kind: 'number' | 'vector' | 'factors' | 'color' | 'choice' | 'name';
  /** Reads a JSON value or its text in markup. */
  read(value: unknown): NonNullable<T> | Mismatch;
  readonly limits: Limits;
}

/** The fields of a node, by name. */
export type Fields = { readonly [name: string]: Field<unknown> };

/** The values of a node whose fields are F. */
export type Values<F> = {
  readonly [K in keyof F as F[K] extends Field<infer T>
    ? undefined extends T
      ? never
      : K
    : never]: F[K] extends Field<infer T> ? T : never;
} & {
  readonly [K in keyof F as F[K] extends Field<infer T>
    ? undefined extends T
      ? K
      : never
    : never]?: F[K] extends Field<infer T> ? NonNullable<T> : never;
};

interface Options<T, D> {
  readonly default?: D;
  readonly switches?: Switches<T>;
}

interface NumberOptions<D> extends Options<number, D> {
  readonly min?: number;
  /** Exclusive lower bound. */
  readonly above?: number;
  readonly max?: number;
  readonly integer?: boolean;
}

/** Lengths stay below this, so that their fourth powers are numbers in f64. */
export const LARGEST_LENGTH = 1e60;

/** What is nearer to 0 is 0, so that squares of what is not are not either. */
const SMALLEST_LENGTH = 1e-60;

const NUMBER_TEXT = /^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*$/;

/** A number, or its text. */
export function number<D extends number | undefined = undefined>(
  doc: string,
  options: NumberOptions<D> = {},
): Field<number | D> {
  const { min, above, max, integer } = options;
  const lower = above !== undefined ? ` above ${above}` : min !== undefined ? ` of at least ${min}` : '';
  const upper = max === undefined ? '' : `${lower ? ' and' : ' of'} at most ${max}`;
  const range = min !== undefined && max !== undefined ? ` from ${min} to ${max}` : lower + upper;
  const expected = new Mismatch(`must be ${integer ? 'a whole number' : 'a number'}${range}`);
  const accepts = (n: number | undefined): n is number =>
    n !== undefined &&
    Number.isFinite(n) &&
    (above === undefined || n > above) &&
    n >= (min ?? -LARGEST_LENGTH) &&
    n <= (max ?? LARGEST_LENGTH) &&
    (!integer || Number.isInteger(n));
  return field('number', doc, options, {
    read: (value) => {
      const n = readNumber(value);
      return accepts(n) ? n : expected;
    },
    limits: { min, above, max, integer },
  });
}

function readNumber(value: unknown): number | undefined {
  const number = typeof value === 'string' && NUMBER_TEXT.test(value) ? Number(value) : value;
  if (typeof number !== 'number') return undefined;
  return Math.abs(number) < SMALLEST_LENGTH ? 0 : number;
}

interface VectorOptions<D> extends Options<Vec3, D> {
  /** Refuses the vector of zeros, which has no direction. */
  readonly nonzero?: boolean;
  /** Refuses components that are not above 0. */
  readonly positive?: boolean;
}

/** Three numbers: `[x, y, z]`, or `"x y z"` with blanks or commas between. */
export function vector<D extends Vec3 | undefined = undefined>(
  doc: string,
  options: VectorOptions<D> = {},
): Field<Vec3 | D> {
  const { nonzero, positive } = options;
  const expected = new Mismatch(`must be three numbers "x y z"${positive ? ' above 0' : nonzero ? ', not all 0' : ''}`);
  return field('vector', doc, options, {
    read: (value) => {
      const v = readTriple(value);
      const valid =
        v?.every((n) => Math.abs(n) <= LARGEST_LENGTH && !(positive && n <= 0)) &&
        !(nonzero && v.every((n) => n === 0));
      return v && valid ? v : expected;
    },
    limits: { nonzero, above: positive ? 0 : undefined },
  });
}

function readTriple(value: unknown): Vec3 | undefined {
  const parts = typeof value === 'string' ? value.trim().split(/\s*,\s*|\s+/) : value;
  if (!Array.isArray(parts) || parts.length !== 3) return undefined;
  const asText = typeof value === 'string';
  const [x, y, z] = parts.map((part) => (asText || typeof part === 'number' ? readNumber(part) : undefined));
  return x !== undefined && y !== undefined && z !== undefined ? Object.freeze([x, y, z] as const) : undefined;
}

/** How large a factor on lengths may be, and one over how small. */
export const LARGEST_FACTOR = 1e12;

/** A factor for each axis, or one for all of them; below 0 it mirrors. */
export function factors<D extends Vec3 | undefined = undefined>(
  doc: string,
  options: Options<Vec3, D> = {},
): Field<Vec3 | D> {
  const expected = new Mismatch('must be one number or three "x y z", each from 1e-12 to 1e12 or the negative of that');
  const accepts = (n: number): boolean => Math.abs(n) >= 1 / LARGEST_FACTOR && Math.abs(n) <= LARGEST_FACTOR;
  return field('factors', doc, options, {
    read: (value) => {
      const one = readNumber(value);
      const three = one === undefined ? readTriple(value) : Object.freeze([one, one, one] as const);
      return three?.every(accepts) ? three : expected;
    },
    limits: { max: LARGEST_FACTOR },
  });
}

interface ColorOptions<D> extends Options<Vec3, D> {
  /** Light may exceed 1 where it is given as numbers; reflectances may not. */
  readonly light?: boolean;
}

/** A CSS colour, or linear Rec. 709 `[r, g, b]`. */
export function color<D extends Vec3 | undefined = undefined>(
  doc: string,
  options: ColorOptions<D> = {},
): Field<Vec3 | D> {
  const max = options.light ? LARGEST_LENGTH : 1;
  const expected = 'must be a colour like "crimson", "#8c3", "oklch(0.7 0.1 200)" or linear [r, g, b]';
  return field('color', doc, options, {
    read: (value) => {
      if (Array.isArray(value)) {
        const rgb = readTriple(value);
        return rgb?.every((channel) => channel >= 0 && channel <= max)
          ? rgb
          : new Mismatch(`must be three numbers from 0${options.light ? '' : ' to 1'}`);
      }
      const rgb = typeof value === 'string' ? readColor(value) : undefined;
      if (typeof rgb === 'string') return new Mismatch(expected, `, which ${rgb}`);
      return rgb ? Object.freeze(rgb) : new Mismatch(expected, suggestion(value, colorNames()));
    },
    limits: { max: options.light ? undefined : 1 },
  });
}

/** One of a closed list of words (or numbers, which may be written as text too). */
export function choice<const C extends string | number>(
  doc: string,
  choices: readonly C[],
  options: Options<C, C> & { readonly default: NoInfer<C> },
): Field<C> {
  const words = choices.map(String);
  const allowed = words.map((word) => `"${word}"`).join(' or ');
  return field('choice', doc, options, {
    read: (value) => {
      const index = typeof value === 'string' || typeof value === 'number' ? words.indexOf(String(value)) : -1;
      return choices[index] ?? new Mismatch(`must be ${allowed}`, suggestion(value, words));
    },
    limits: { choices },
  });
}

/** A short text without meaning to the engine: an author's name for something, or where something is. */
export function name(doc: string, what = 'a name'): Field<string | undefined> {
  return field(
    'name',
    doc,
    {},
    {
      read: (value) => (typeof value === 'string' && value.trim() ? value.trim() : new Mismatch(`must be ${what}`)),
      limits: {},
    },
  );
}

type Reader<T> = { read(value: unknown): NonNullable<T> | Mismatch; limits: Limits };

function field<T, D extends T | undefined>(
  kind: Field<T>['kind'],
  doc: string,
  options: Options<NonNullable<T>, D>,
  reader: Reader<T>,
): Field<T | D> {
  const switches = Object.entries(options.switches ?? {});
  return {
    kind,
    doc,
    default: options.default as D,
    features: (value) => switches.filter(([, needs]) => needs(value as NonNullable<T>)).map(([feature]) => feature),
    read: reader.read as Field<T | D>['read'],
    limits: reader.limits,
  };
}
