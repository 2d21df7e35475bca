import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import fc from 'fast-check';
import { assembleGlsl } from '../../packages/core/src/assemble-glsl.ts';
import { glslFiles } from '../../packages/core/src/glsl-files.ts';
import { moreNames } from '../../packages/core/src/load-parts.ts';
import { wholeFiles } from '../../packages/core/src/whole-files.ts';
import { plainGlsl } from '../node/plain-glsl.mjs';

const absent = new Set(moreNames);

/** The names that a text asks for. */
const asked = (text: string): string[] => [
  ...new Set(text.match(/^\s*#\s*(?:el)?if.*/gm)?.flatMap((line) => line.match(/\b[A-Z][A-Z_\d]*\b/g) ?? [])),
];

/** A text by itself, where names are defined. */
const assembled = (text: string, defined: ReadonlySet<string>): string =>
  assembleGlsl('file', { files: { file: text.replace(/^\s*#include/gm, 'include') }, defined }).text;

suite('shaders of scenes that need no chunk', () => {
  for (const [name, text] of Object.entries(glslFiles)) {
    const names = asked(text).filter((one) => !absent.has(one));
    test(`${name} says the same without the branches of others`, () => {
      const plain = plainGlsl(text, absent);
      assert.equal(plain.split('\n').length, text.split('\n').length);
      assert.deepEqual(
        asked(plain).filter((one) => absent.has(one)),
        [],
      );
      fc.assert(
        fc.property(fc.subarray(names), (some) => {
          const defined = new Set(some);
          assert.equal(assembled(plain, defined), assembled(text, defined));
        }),
      );
    });
  }

  test('what has such branches comes whole with the chunk', () => {
    const branched = Object.entries(glslFiles).filter(([, text]) => asked(text).some((name) => absent.has(name)));
    assert.deepEqual(branched.map(([name]) => name).sort(), Object.keys(wholeFiles).sort());
  });
});
