/** Kinds of fields: how each is read from JSON or from the text of an attribute, and how its JSON Schema looks. */
import { colorNames, readColor } from './color.ts';
import { say } from './say.ts';
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
  /** Not a place or a direction, but a way from one place to another. */
  readonly edge?: boolean | undefined;
  readonly choices?: readonly (string | number)[];
}

/** What a value should have been. Returned instead of a value that cannot be read. */
export class Mismatch {
  /** What the field takes: `must be a number above 0`. */
  readonly allowed: () => string;
  /** What to say after the value that was found: ` (did you mean "red"?)`. */
  readonly hint: () => string;

  constructor(allowed: () => string, hint = () => '') {
    this.allowed = allowed;
    this.hint = hint;
  }

  /** The whole sentence, for a field as it is spelt and the value that was found. */
  sentence(field: string, found: unknown): string {
    return say('field', field, this.allowed(), found, this.hint());
  }
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
  const limits = { min, above, max, integer };
  const expected = new Mismatch(() => say('number', limits));
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
    limits,
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
  /** A way whose length counts; other vectors that must not be 0 are directions. */
  readonly edge?: boolean;
}

/** Three numbers: `[x, y, z]`, or `"x y z"` with blanks or commas between. */
export function vector<D extends Vec3 | undefined = undefined>(
  doc: string,
  options: VectorOptions<D> = {},
): Field<Vec3 | D> {
  const { nonzero, positive, edge } = options;
  const limits = { nonzero, above: positive ? 0 : undefined, edge };
  const expected = new Mismatch(() => say('vector', limits));
  return field('vector', doc, options, {
    read: (value) => {
      const v = readTriple(value);
      const valid =
        v?.every((n) => Math.abs(n) <= LARGEST_LENGTH && !(positive && n <= 0)) &&
        !(nonzero && v.every((n) => n === 0));
      return v && valid ? v : expected;
    },
    limits,
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
  const expected = new Mismatch(() => say('factors'));
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
  const limits = { max: options.light ? undefined : 1 };
  return field('color', doc, options, {
    read: (value) => {
      if (Array.isArray(value)) {
        const rgb = readTriple(value);
        return rgb?.every((channel) => channel >= 0 && channel <= max)
          ? rgb
          : new Mismatch(() => say('linearColor', limits));
      }
      const rgb = typeof value === 'string' ? readColor(value) : undefined;
      if (typeof rgb === 'object') return Object.freeze(rgb);
      return new Mismatch(
        () => say('color'),
        () => (rgb ? say(rgb) : say('suggestion', value, colorNames())),
      );
    },
    limits,
  });
}

/** One of a closed list of words (or numbers, which may be written as text too). */
export function choice<const C extends string | number>(
  doc: string,
  choices: readonly C[],
  options: Options<C, C> & { readonly default: NoInfer<C> },
): Field<C> {
  const words = choices.map(String);
  return field('choice', doc, options, {
    read: (value) => {
      const index = typeof value === 'string' || typeof value === 'number' ? words.indexOf(String(value)) : -1;
      return (
        choices[index] ??
        new Mismatch(
          () => say('choice', words),
          () => say('suggestion', value, words),
        )
      );
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
      read: (value) =>
        typeof value === 'string' && value.trim() ? value.trim() : new Mismatch(() => say('name', what)),
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
