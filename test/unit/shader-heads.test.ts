/** Each shader file begins with a comment that says what it is for, and tells its precision. */
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

const files = readdirSync('shaders', { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.glsl'));

for (const file of files) {
  test(`shaders/${file} says what it is, and its precision`, () => {
    const text = readFileSync(`shaders/${file}`, 'utf8');
    assert.match(text, /^(?:#version 300 es\n)?(?:#include "[^"]+"\n|\n)*\/\/ \S/);
    // A file with a main() may set it for all that it includes; constants are written as they are.
    assert.match(text, file === 'constants.glsl' ? /^const float/m : /\bPrecision: \S|^precision highp float;/m);
  });
}
