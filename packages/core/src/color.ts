/**
 * Colours as authors write them, to linear Rec. 709 (the primaries of sRGB), which is what light is computed in. The
 * names come from culori; its parser would be the largest thing that a page loads, and what is wanted of it is this.
 * Source: CSS Color Module Level 4; oklch: B. Ottosson, "A perceptual color space for image processing" (2020).
 */
import { colorsNamed } from 'culori/fn';
import type { Vec3 } from './vector.ts';

export const colorNames: readonly string[] = Object.keys(colorsNamed);

/** How far outside [0, 1] rounding may carry a colour that is meant to lie on the border of the gamut. */
const GAMUT_ROUNDING = 2 ** -13;

/**
 * Reads a CSS colour: a name, hex, `rgb()`, `hsl()`, `oklch()`, `color(srgb …)` or `color(srgb-linear …)`.
 * Returns linear Rec. 709 in [0, 1]³, what is wrong with it in words, or undefined for what is no colour at all.
 */
export function readColor(text: string): Vec3 | string | undefined {
  const color = text.trim().toLowerCase();
  const named: number | undefined = Object.hasOwn(colorsNamed, color) ? colorsNamed[color as 'red'] : undefined;
  const read = named === undefined ? (readHex(color) ?? readFunction(color)) : readHex(`#${hex6(named)}`);
  if (!read) return undefined;
  if (read.alpha !== 1) return 'has an alpha; use the opaque colour';
  if (read.linear.some((channel) => !(channel >= -GAMUT_ROUNDING && channel <= 1 + GAMUT_ROUNDING))) {
    return 'is outside the sRGB gamut';
  }
  const [r, g, b] = read.linear.map((channel) => Math.min(1, Math.max(0, channel)));
  return [r as number, g as number, b as number];
}

interface Read {
  readonly linear: Vec3;
  readonly alpha: number;
}

const hex6 = (rgb: number): string => rgb.toString(16).padStart(6, '0');

/** `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`. */
function readHex(text: string): Read | undefined {
  const digits = /^#([\da-f]{3,4}|[\da-f]{6}|[\da-f]{8})$/.exec(text)?.[1];
  if (!digits) return undefined;
  const pairs = digits.length < 6 ? digits.replace(/./g, '$&$&') : digits;
  const [r, g, b, alpha] = [0, 2, 4, 6].map((i) => Number.parseInt(pairs.slice(i, i + 2) || 'ff', 16) / 255);
  return { linear: fromSrgb([r as number, g as number, b as number]), alpha: alpha as number };
}

const mapped = (color: Vec3, f: (channel: number) => number): Vec3 => [f(color[0]), f(color[1]), f(color[2])];

/** Decodes the transfer function of sRGB. */
const fromSrgb = (color: Vec3): Vec3 => mapped(color, (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));

/** For each function: what 100 % of each number is, and the way to linear Rec. 709. */
const spaces: { readonly [name: string]: { readonly full: Vec3; readonly convert: (color: Vec3) => Vec3 } } = {
  rgb: { full: [255, 255, 255], convert: ([r, g, b]) => fromSrgb([r / 255, g / 255, b / 255]) },
  hsl: { full: [360, 100, 100], convert: fromHsl },
  oklch: { full: [1, 0.4, 360], convert: fromOklch },
  srgb: { full: [1, 1, 1], convert: fromSrgb },
  'srgb-linear': { full: [1, 1, 1], convert: (color) => color },
};

/** `rgb(1 2 3 / 0.5)`, the same with commas, or `color(srgb 0.1 0.2 0.3)`. */
function readFunction(text: string): Read | undefined {
  const [, name, inside = ''] = /^(rgb|hsl|oklch|color)a?\(([^()]*)\)$/.exec(text) ?? [];
  if (!name) return undefined;
  const words = inside.trim().split(/\s*[,/]\s*|\s+/);
  const space = spaces[name === 'color' ? (words.shift() as string) : name];
  if (!space || words.length < 3 || words.length > 4) return undefined;
  const numbers = words.map((word, i) => readNumber(word, space.full[i] ?? 1));
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

function fromHsl([hue, saturation, lightness]: Vec3): Vec3 {
  const [s, l] = [saturation / 100, lightness / 100];
  const chroma = s * Math.min(l, 1 - l);
  return fromSrgb(
    mapped([0, 8, 4], (n) => {
      const k = (((n + hue / 30) % 12) + 12) % 12;
      return l - chroma * Math.max(-1, Math.min(k - 3, 9 - k, 1));
    }),
  );
}

function fromOklch([lightness, chroma, hue]: Vec3): Vec3 {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}
