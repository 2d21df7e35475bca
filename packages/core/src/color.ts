/**
 * Colours as authors write them, to linear Rec. 709 (the primaries of sRGB), which is what light is computed in. Those
 * that no table of names and no other space is needed for; the rest comes with `css-colors.ts`.
 * Source: CSS Color Module Level 4.
 */
import type { Vec3 } from './vector.ts';

/** A space that colours are given in: what 100 % of each number is, and the way to linear Rec. 709. */
export interface ColorSpace {
  readonly full: Vec3;
  readonly convert: (color: Vec3) => Vec3;
}

/** Colours of CSS, or more of them. */
export interface ColorWords {
  /** By name, what stands after `#` in the hexadecimal notation. */
  readonly names: ReadonlyMap<string, string>;
  /** By the name of the function, which for `color()` is followed by that of the space. */
  readonly spaces: ReadonlyMap<string, ColorSpace>;
}

/** How far outside [0, 1] rounding may carry a colour that is meant to lie on the border of the gamut. */
const GAMUT_ROUNDING = 2 ** -13;

/**
 * Reads a CSS colour: a name, hex, `rgb()`, `hsl()`, `oklch()`, `color(srgb …)` or `color(srgb-linear …)`.
 * Returns linear Rec. 709 in [0, 1]³, what is wrong with it, or undefined for what is no colour at all.
 */
export function readColor(text: string): Vec3 | 'transparentColor' | 'strongColor' | undefined {
  const color = text.trim().toLowerCase();
  const named = words.names.get(color);
  const read = readHex(named ? `#${named}` : color) ?? readFunction(color);
  if (!read) return undefined;
  if (read.alpha !== 1) return 'transparentColor';
  if (read.linear.some((channel) => !(channel >= -GAMUT_ROUNDING && channel <= 1 + GAMUT_ROUNDING))) {
    return 'strongColor';
  }
  const [r, g, b] = read.linear.map((channel) => Math.min(1, Math.max(0, channel)));
  return [r as number, g as number, b as number];
}

interface Read {
  readonly linear: Vec3;
  readonly alpha: number;
}

/** `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`. */
function readHex(text: string): Read | undefined {
  const digits = /^#([\da-f]{3,4}|[\da-f]{6}|[\da-f]{8})$/.exec(text)?.[1];
  if (!digits) return undefined;
  const pairs = digits.length < 6 ? digits.replace(/./g, '$&$&') : digits;
  const [r, g, b, alpha] = [0, 2, 4, 6].map((i) => Number.parseInt(pairs.slice(i, i + 2) || 'ff', 16) / 255);
  return { linear: fromSrgb([r as number, g as number, b as number]), alpha: alpha as number };
}

export const mapped = (color: Vec3, f: (channel: number) => number): Vec3 => [f(color[0]), f(color[1]), f(color[2])];

/** Decodes the transfer function of sRGB. */
export const fromSrgb = (color: Vec3): Vec3 =>
  mapped(color, (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));

let words: ColorWords = {
  names: new Map([
    ['black', '000'],
    ['white', 'fff'],
  ]),
  spaces: new Map([
    ['rgb', { full: [255, 255, 255], convert: (color) => fromSrgb(mapped(color, (c) => c / 255)) }],
    ['color srgb', { full: [1, 1, 1], convert: fromSrgb }],
    ['color srgb-linear', { full: [1, 1, 1], convert: (color) => color }],
  ]),
};
let hasAll = false;

/** Makes the other colours known. */
export function registerColors({ names, spaces }: ColorWords): void {
  words = { names, spaces: new Map([...words.spaces, ...spaces]) };
  hasAll = true;
}

/** Whether all colours of CSS are known. */
export const knowsAllColors = (): boolean => hasAll;

export const colorNames = (): readonly string[] => [...words.names.keys()];

/** `rgb(1 2 3 / 0.5)`, the same with commas, or `color(srgb 0.1 0.2 0.3)`. */
function readFunction(text: string): Read | undefined {
  const [, name, inside = ''] = /^([a-z]+?)a?\(([^()]*)\)$/.exec(text) ?? [];
  if (!name) return undefined;
  const parts = inside.trim().split(/\s*[,/]\s*|\s+/);
  const space = words.spaces.get(name === 'color' ? `color ${parts.shift()}` : name);
  if (!space || parts.length < 3 || parts.length > 4) return undefined;
  const numbers = parts.map((word, i) => readNumber(word, space.full[i] ?? 1));
  if (numbers.some((number) => Number.isNaN(number))) return undefined;
  const [x, y, z, alpha = 1] = numbers as [number, number, number];
  return { linear: space.convert([x, y, z]), alpha };
}

const UNITS: { readonly [unit: string]: number } = { '': 1, deg: 1, grad: 0.9, rad: 180 / Math.PI, turn: 360 };

/** A number, a percentage of `full`, an angle in degrees, or `none`, which is 0; NaN for anything else. */
function readNumber(word: string, full: number): number {
  if (word === 'none') return 0;
  const [, digits, unit = ''] = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(%|deg|grad|rad|turn)?$/.exec(word) ?? [];
  return Number(digits) * (unit === '%' ? full / 100 : (UNITS[unit] as number));
}
