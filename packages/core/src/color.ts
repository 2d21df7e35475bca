/**
 * Colours as authors write them, to linear Rec. 709 (the primaries of sRGB), which is what light is computed in. Those
 * that neither names nor other spaces are needed for; the rest comes with `css-colors.ts`.
 * Source: CSS Color Module Level 4.
 */
import type { Vec3 } from './vector.ts';

/** A colour, not yet judged. */
export interface ReadColor {
  /** Linear Rec. 709. */
  readonly linear: Vec3;
  readonly alpha: number;
}

/** All colours of CSS. */
export interface ColorWords {
  readonly names: readonly string[];
  /** Reads a name or a function, in lower case; undefined for what is neither. */
  read(text: string): ReadColor | undefined;
}

let words: ColorWords | undefined;

/** Makes the colours of CSS known. */
export function registerColors(all: ColorWords): void {
  words = all;
}

/** Whether the colours of CSS are known. */
export const knowsAllColors = (): boolean => !!words;

export const colorNames = (): readonly string[] => words?.names ?? [];

/** How far outside [0, 1] rounding may carry a colour that is meant to lie on the border of the gamut. */
const GAMUT_ROUNDING = 2 ** -13;

/**
 * Reads a CSS colour: hex, `black`, `white` or `color(srgb-linear …)` with plain numbers; a name, `rgb()`, `hsl()`, `oklch()` or
 * any `color(srgb …)` when the colours of CSS are loaded.
 * Returns linear Rec. 709 in [0, 1]³, what is wrong with it, or undefined for what is no colour at all.
 */
export function readColor(text: string): Vec3 | 'transparentColor' | 'strongColor' | undefined {
  const color = text.trim().toLowerCase();
  const read = readHex(color) ?? readLinear(color) ?? words?.read(color);
  if (!read) return undefined;
  if (read.alpha !== 1) return 'transparentColor';
  if (read.linear.some((channel) => !(channel >= -GAMUT_ROUNDING && channel <= 1 + GAMUT_ROUNDING))) {
    return 'strongColor';
  }
  return mapped(read.linear, (channel) => Math.min(1, Math.max(0, channel)));
}

/** `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`, or the name of one of the two colours that are none. */
export function readHex(text: string): ReadColor | undefined {
  const hex = text === 'black' ? '#000' : text === 'white' ? '#fff' : text;
  const digits = /^#([\da-f]{3,4}|[\da-f]{6}|[\da-f]{8})$/.exec(hex)?.[1];
  if (!digits) return undefined;
  const pairs = digits.length < 6 ? digits.replace(/./g, '$&$&') : digits;
  const [r, g, b, alpha] = [0, 2, 4, 6].map((i) => Number.parseInt(pairs.slice(i, i + 2) || 'ff', 16) / 255);
  return { linear: fromSrgb([r as number, g as number, b as number]), alpha: alpha as number };
}

function readLinear(text: string): ReadColor | undefined {
  const numbers = /^color\(srgb-linear ([\d.]+) ([\d.]+) ([\d.]+)\)$/.exec(text)?.slice(1).map(Number);
  return numbers?.every(Number.isFinite) ? { linear: numbers as unknown as Vec3, alpha: 1 } : undefined;
}

export const mapped = (color: Vec3, f: (channel: number) => number): Vec3 => [f(color[0]), f(color[1]), f(color[2])];

/** Decodes the transfer function of sRGB. */
export const fromSrgb = (color: Vec3): Vec3 =>
  mapped(color, (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
