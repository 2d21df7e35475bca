/**
 * The colours of CSS that have a name, or are given in a space that is not that of screens. Importing this makes them known.
 * The names come from culori; its parser would be the largest thing that a page loads, and what is wanted of it is this.
 * Source: CSS Color Module Level 4; oklch: B. Ottosson, "A perceptual color space for image processing" (2020).
 */
import { colorsNamed } from 'culori/fn';
import { fromSrgb, mapped, registerColors } from './color.ts';
import type { Vec3 } from './vector.ts';

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

registerColors({
  names: new Map(Object.entries(colorsNamed).map(([name, rgb]) => [name, rgb.toString(16).padStart(6, '0')])),
  spaces: new Map([
    ['hsl', { full: [360, 100, 100], convert: fromHsl }],
    ['oklch', { full: [1, 0.4, 360], convert: fromOklch }],
  ]),
});
