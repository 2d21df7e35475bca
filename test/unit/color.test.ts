import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parseScene } from '@ray-scene/core';
import { colorsNamed, converter } from 'culori';
import fc from 'fast-check';

const read = (color: string) => parseScene({ materials: { a: { color } } }).materials.a?.color;

const toLinear = converter('lrgb');

/** What culori, another reader of CSS colours, makes of it. */
function agrees(text: string): void {
  const other = toLinear(text);
  assert.ok(other, text);
  const ours = read(text) ?? [];
  [other.r, other.g, other.b].forEach((channel, i) => {
    assert.ok(Math.abs(channel - (ours[i] as number)) < 1e-4, `${text}: ${ours} against ${JSON.stringify(other)}`);
  });
}

test('every colour name is read as culori reads it', () => {
  for (const name of Object.keys(colorsNamed)) agrees(name);
});

const byte = fc.integer({ min: 0, max: 255 });
const percent = fc.integer({ min: 0, max: 100 });
const hue = fc.integer({ min: -360, max: 720 });

test('hex, rgb(), hsl(), oklch() and color() are read as culori reads them', () => {
  fc.assert(
    fc.property(byte, byte, byte, percent, percent, hue, (r, g, b, s, l, h) => {
      agrees(`#${[r, g, b].map((x) => x.toString(16).padStart(2, '0')).join('')}`);
      agrees(`rgb(${r} ${g} ${b})`);
      agrees(`rgb(${r}, ${g}, ${b})`);
      agrees(`rgb(${s}% ${l}% ${s}%)`);
      agrees(`hsl(${h} ${s}% ${l}%)`);
      agrees(`hsl(${h}deg, ${s}%, ${l}%)`);
      agrees(`oklch(${l}% 0.01 ${h})`.replace(/^oklch\((0|1|2|98|99|100)%/, 'oklch(50%'));
      agrees(`color(srgb ${s / 100} ${l / 100} ${s / 200})`);
      agrees(`color(srgb-linear ${s}% ${l}% 0)`);
    }),
  );
});

for (const [what, text, reason] of [
  ['an alpha', 'rgb(1 2 3 / 50%)', 'has an alpha; use the opaque colour'],
  ['an alpha in hex', '#12345678', 'has an alpha; use the opaque colour'],
  ['a channel above its range', 'rgb(300 0 0)', 'is outside the sRGB gamut'],
  ['a colour that no screen shows', 'oklch(0.7 0.4 150)', 'is outside the sRGB gamut'],
] as const) {
  test(`a colour with ${what} is refused, and says why`, () => {
    assert.throws(() => read(text), new RegExp(`, which ${reason}`));
  });
}

for (const [text, hint] of [
  ['reed', ' (did you mean "red"?)'],
  ['rgb(1 2)', ''],
  ['constructor', ''],
] as const) {
  test(`"${text}" is no colour`, () => {
    const message = `must be a colour like "crimson", "#8c3", "oklch(0.7 0.1 200)" or, in JSON, linear [r, g, b], not "${text}"${hint}`;
    assert.throws(() => read(text), { message: `materials.a: color ${message}` });
  });
}
