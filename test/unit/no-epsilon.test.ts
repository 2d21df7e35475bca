// No small constant decides in a shader, or in the reference, what is in front of what: there is no length that is small in
// every scene. Small numbers that are there for another reason are listed with it.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Below it, a number is small. */
const SMALL = 0.05;

const NEARER_THAN_A_TENTH = 'which of two exact forms loses less: squared, within a tenth of the shape’s own size';

const reasons: readonly [file: RegExp, number: string, reason: string][] = [
  [/constants\.glsl$/, '1e-37', 'keeps 0 / 0 defined: no length that f32 holds is below it'],
  [/shape\/(quad|sphere-wide|triangle|disc|cylinder|cone)\.glsl$/, '0.01', NEARER_THAN_A_TENTH],
  [/circle\.glsl$/, '0.0208603085029', 'coefficient of a polynomial'],
  [/circle\.glsl$/, '0.000904060569983', 'coefficient of a polynomial'],
  [/circle\.glsl$/, '0.00459959170717', 'coefficient of a polynomial'],
  [/glint\.(glsl|ts)$/, '3.814697265625e-6', 'an angle: how dense directions are in f32'],
  [/output\.(glsl|ts)$/, '0.04045', 'sRGB'],
];

const filesIn = (directory: string, ending: string): readonly string[] =>
  readdirSync(`${root}/${directory}`, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith(ending))
    .map((file) => `${directory}/${file.replaceAll('\\', '/')}`);

/** What finds light; how a picture is shown, and how its noise is judged, has nothing to hit or to miss. */
const tracing = [...filesIn('shaders', '.glsl'), ...filesIn('packages/core/src/reference', '.ts')].filter(
  (file) => !/shaders\/(display|noise)/.test(file),
);

const withoutComments = (text: string): string => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '');

const numbersIn = (code: string): readonly string[] =>
  [...code.matchAll(/(?<![\w.])(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(?![\w.])/gi)].map(([number]) => number);

const allowed = (file: string, number: string): boolean =>
  reasons.some(([where, which]) => where.test(file) && which === number);

test('the search finds numbers as they are written', () => {
  assert.deepEqual(numbersIn('a1 + 1e-4 * x.y - .5 / 0.001, vec3(2.0)'), ['1e-4', '.5', '0.001', '2.0']);
  assert.equal(withoutComments('a // 1e-4\nb /* 0.1 */'), 'a \nb ');
});

test('shaders and the reference hold no small constant but for a reason that is no length', () => {
  assert.ok(tracing.length > 80, 'all files are looked at');
  const found = tracing.flatMap((file) =>
    numbersIn(withoutComments(readFileSync(`${root}/${file}`, 'utf8')))
      .filter((number) => Number(number) > 0 && Number(number) < SMALL && !allowed(file, number))
      .map((number) => `${file}: ${number}`),
  );
  assert.deepEqual(found, []);
});

test('nothing there is called an epsilon or a bias, nor made of the spacing of floats at 1', () => {
  const word = /\b\w*(epsilon|bias)\w*\b|exp2\(-|2 \*\* -(?!126\b)/i;
  const found = tracing.filter((file) => word.test(withoutComments(readFileSync(`${root}/${file}`, 'utf8'))));
  assert.deepEqual(found, []);
});

test('every reason is still of use', () => {
  const idle = reasons.filter(
    ([where, number]) =>
      !tracing.some(
        (file) =>
          where.test(file) && numbersIn(withoutComments(readFileSync(`${root}/${file}`, 'utf8'))).includes(number),
      ),
  );
  assert.deepEqual(idle, []);
});
