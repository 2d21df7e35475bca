import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { suite, test } from 'node:test';
import { stripGlsl } from '../node/strip-glsl.mjs';

const folder = new URL('../../shaders/', import.meta.url);
const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.glsl'));

/** The words and signs of a line, and its numbers, spelt alike where they are equal. */
const tokens = (line: string): string[] =>
  [...line.replace(/\/\/.*/, '').matchAll(/[a-z_]\w*|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?u?|\S/gi)].map(([token]) =>
    /^\.?\d[^u]*$/.test(token) ? String(Number(token)) : token,
  );

suite('shaders in the one file', () => {
  for (const file of files) {
    test(`${file} says the same, line by line, but for the names of variables`, () => {
      const lines = readFileSync(new URL(file, folder), 'utf8').split('\n');
      const stripped = stripGlsl(lines.join('\n')).split('\n');
      assert.equal(stripped.length, lines.length);
      let names = new Map<string, string>();
      for (const [i, line] of lines.entries()) {
        const [before, after] = [tokens(line), tokens(stripped[i] as string)];
        assert.equal(after.length, before.length, line);
        before.forEach((token, j) => {
          const isMember = before[j - 1] === '.';
          const name = isMember ? token : (names.get(token) ?? after[j] ?? '');
          assert.equal(after[j], name, line);
          if (name !== token) assert.match(name, /^[a-z]$/, line);
          if (!isMember && !line.startsWith('#') && /^[a-z_]/i.test(token)) names.set(token, name);
        });
        assert.equal(new Set(names.values()).size, names.size, `two names have become one before: ${line}`);
        // A function ends, and with it its names.
        if (line.startsWith('}')) names = new Map();
      }
    });
  }

  test('signs stay apart that would be others together', () => {
    assert.equal(stripGlsl('  x = a - -b + +0.50;'), 'x=a- -b+ +.50;');
    assert.equal(stripGlsl('  x = 10.0 - 1e-3 * 2.0;'), 'x=10.-1e-3*2.;');
  });

  test('a name of one letter is taken by nothing else', () => {
    const glsl = 'float f(float own, vec3 a) {\n  float t = a.x * own;\n  return t;\n}';
    assert.equal(stripGlsl(glsl), 'float f(float b,vec3 a){\nfloat t=a.x*b;\nreturn t;\n}');
  });

  test('what another file may refer to keeps its name', () => {
    const glsl = 'float f(float own) {\n#include "x.glsl"\n  return own;\n}';
    assert.equal(stripGlsl(glsl), 'float f(float own){\n#include "x.glsl"\nreturn own;\n}');
  });
});
