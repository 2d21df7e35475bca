/** The fields of the core's tables as properties and attributes of elements. */
import { type Fields, Mismatch } from '@ray-scene/core';

/** `checkerSize` as markup spells it: `checker-size`. */
export const attributeOf = (field: string): string => field.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** `checker-size` as the table spells it: `checkerSize`. */
export const fieldOf = (attribute: string): string =>
  attribute.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());

/** An element whose fields are properties. */
export interface FieldHost extends HTMLElement {
  readonly fields: Fields;
  /** What the author gave: a value as the table reads it, or as it came where it cannot be read. */
  readonly given: { [field: string]: unknown };
  fieldChanged(): void;
}

/** The property of each field. Only choices reflect: their truth is the attribute. */
export function defineFieldProperties(element: { readonly prototype: FieldHost }, fields: Fields): void {
  for (const [name, { kind }] of Object.entries(fields)) {
    Object.defineProperty(element.prototype, name, {
      get(this: FieldHost): unknown {
        const read = readAs(this, name, this.given[name]);
        // Frozen, as the table's own default must not change either.
        return read === undefined || read instanceof Mismatch ? Object.freeze(this.fields[name]?.default) : read;
      },
      set(this: FieldHost, value: unknown) {
        if (kind !== 'choice') give(this, name, value);
        else if (value === undefined || value === null) this.removeAttribute(attributeOf(name));
        else this.setAttribute(attributeOf(name), String(value));
      },
      configurable: true,
      enumerable: true,
    });
  }
}

/** What a field makes of a value: a `Mismatch` where it cannot be read, undefined where there is none. */
export const readAs = ({ fields }: FieldHost, name: string, value: unknown): unknown =>
  value === undefined || value === null ? undefined : fields[name]?.read(value);

/** Takes a value for a field; null and undefined bring its default back. Arrays are copied. */
export function give(host: FieldHost, name: string, value: unknown): void {
  const read = readAs(host, name, value);
  host.given[name] = read instanceof Mismatch ? value : read;
  host.fieldChanged();
}

/** Takes over what was set as plain properties before the class of the element was known. */
export function adoptEarlyProperties(host: HTMLElement, names: readonly string[]): void {
  const properties = host as unknown as { [name: string]: unknown };
  for (const name of names) {
    if (Object.hasOwn(properties, name)) {
      const value = properties[name];
      delete properties[name];
      properties[name] = value;
    }
  }
}
