/**
 * The colours of CSS that have a name or are a function. Importing this makes them known.
 * The names come from culori; its parser would be the largest thing that a page loads, and what is wanted of it is this.
 * Source: CSS Color Module Level 4; oklch: B. Ottosson, "A perceptual color space for image processing" (2020).
 */
import { colorsNamed } from 'culori/fn';
import { fromSrgb, mapped, type ReadColor, readHex, registerColors } from './color.ts';
import type { Vec3 } from './vector.ts';

/** A space that colours are given in: what 100 % of each number is, and the way to linear Rec. 709. */
interface ColorSpace {
  readonly full: Vec3;
  readonly convert: (color: Vec3) => Vec3;
}

/** By the name of the function, which for `color()` is followed by that of the space. */
const spaces: ReadonlyMap<string, ColorSpace> = new Map([
  ['rgb', { full: [255, 255, 255], convert: (color) => fromSrgb(mapped(color, (c) => c / 255)) }],
  ['hsl', { full: [360, 100, 100], convert: fromHsl }],
  ['oklch', { full: [1, 0.4, 360], convert: fromOklch }],
  ['color srgb', { full: [1, 1, 1], convert: fromSrgb }],
  ['color srgb-linear', { full: [1, 1, 1], convert: (color) => color }],
]);

const names: ReadonlyMap<string, number> = new Map(Object.entries(colorsNamed));

function readName(text: string): ReadColor | undefined {
  const rgb = names.get(text);
  return rgb === undefined ? undefined : readHex(`#${rgb.toString(16).padStart(6, '0')}`);
}

/** `rgb(1 2 3 / 0.5)`, the same with commas, or `color(srgb 0.1 0.2 0.3)`. */
function readFunction(text: string): ReadColor | undefined {
  const [, name, inside = ''] = /^([a-z]+?)a?\(([^()]*)\)$/.exec(text) ?? [];
  if (!name) return undefined;
  const parts = inside.trim().split(/\s*[,/]\s*|\s+/);
  const space = spaces.get(name === 'color' ? `color ${parts.shift()}` : name);
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

registerColors({ names: [...names.keys()], read: (text) => readName(text) ?? readFunction(text) });
