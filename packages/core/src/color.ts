/** Colours as authors write them, to linear Rec. 709 (the primaries of sRGB), which is what light is computed in. */
import { converter, modeHsl, modeLrgb, modeOklch, modeRgb, parse, useMode } from 'culori/fn';
import type { Vec3 } from './vector.ts';

useMode(modeRgb);
useMode(modeHsl);
useMode(modeOklch);
useMode(modeLrgb);

const toSrgb = converter('rgb');
const toLinear = converter('lrgb');

/** How far outside [0, 1] rounding may carry a colour that is meant to lie on the border of the gamut. */
const GAMUT_ROUNDING = 2 ** -20;

/**
 * Reads a CSS colour: a name, hex, `rgb()`, `hsl()`, `oklch()`, `color(srgb …)` or `color(srgb-linear …)`.
 * Returns linear Rec. 709 in [0, 1]³, or what is wrong with it in words.
 */
export function readColor(text: string): Vec3 | string {
  const color = parse(text.trim());
  if (!color) return 'is not a colour';
  if (color.alpha !== undefined && color.alpha !== 1) return 'has an alpha; use the opaque colour';
  const { r, g, b } = toSrgb(color);
  if ([r, g, b].some((channel) => !(channel >= -GAMUT_ROUNDING && channel <= 1 + GAMUT_ROUNDING))) {
    return 'is outside the sRGB gamut';
  }
  const linear = color.mode === 'lrgb' ? color : toLinear({ mode: 'rgb', r: inUnit(r), g: inUnit(g), b: inUnit(b) });
  return [linear.r, linear.g, linear.b];
}

const inUnit = (channel: number): number => Math.min(1, Math.max(0, channel));
