// What the shader of a scene holds of BSDFs: the lobes of its materials, and nothing else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assembleGlsl } from '../../packages/core/src/assemble-glsl.ts';
import { glslFiles } from '../../packages/core/src/glsl-files.ts';
import { pathFiles } from '../../packages/core/src/path-files.ts';
import { definedFor, materials } from '../bsdf/cases.ts';

const textFor = (defined: ReadonlySet<string>): string =>
  assembleGlsl('material/bsdf.glsl', { files: { ...glslFiles, ...pathFiles }, defined }).text;

/** Without white space at the ends of lines: what a driver has to read. */
const sizeOf = (text: string): number => text.replace(/^\s+/gm, '').length;

const shaderOf = (...names: readonly string[]): string =>
  textFor(definedFor(names.map((name) => materials[name] as NonNullable<(typeof materials)[string]>)));

const has = (text: string, ...words: readonly string[]): readonly string[] =>
  words.filter((word) => new RegExp(`\\b${word}\\b`).test(text));

const FACETS = ['splitAt', 'Split', 'Facet', 'facetProbability', 'mirrored', 'schlickWeight', 'metalness', 'f0'];
const ROUGH = ['alpha', 'ggx', 'smithOverCosine', 'visibleNormal'];
const THROUGH = ['transmitted', 'transmission', 'exactFresnel', 'refracted', 'sampleRefraction', 'sampleWall', 'eta'];
const BASE = ['cosineDirection', 'diffuse', 'circle'];

test('dull surfaces are a cosine lobe', () => {
  const text = shaderOf('dull');
  assert.deepEqual(has(text, ...FACETS, ...ROUGH, ...THROUGH), []);
  assert.ok(sizeOf(text) < 1800, `${sizeOf(text)}`);
});

test('clear glass holds nothing rough and nothing diffuse', () => {
  assert.deepEqual(has(shaderOf('glass', 'glass from inside'), ...ROUGH, ...BASE, 'sampleWall', 'schlickWeight'), []);
});

test('ground glass holds nothing diffuse, no metal and no pane', () => {
  assert.deepEqual(
    has(shaderOf('ground glass'), 'cosineDirection', 'diffuse', 'metalness', 'metal', 'schlickWeight', 'sampleWall'),
    [],
  );
});

test('panes hold no refraction', () => {
  assert.deepEqual(has(shaderOf('ground pane'), 'refracted', 'sampleRefraction', 'refraction'), []);
});

test('metals hold nothing diffuse, and no glass', () => {
  assert.deepEqual(has(shaderOf('gold'), ...THROUGH, 'cosineDirection', 'diffuse', 'f0', 'metalness'), []);
  assert.deepEqual(has(shaderOf('polished gold'), ...THROUGH, ...ROUGH, ...BASE, 'f0'), []);
});

test('plastic holds no glass and no metal', () => {
  assert.deepEqual(has(shaderOf('plastic'), ...THROUGH, 'metal', 'metalness', 'f90'), []);
});

test('each name that a shader may ask for adds what it stands for', (t) => {
  const all = textFor(definedFor(Object.values(materials)));
  const rows = Object.keys(materials).map((name) => `${name}: ${sizeOf(shaderOf(name))}`);
  t.diagnostic(`characters of BSDFs: all ${sizeOf(all)}; ${rows.join(', ')}`);
  for (const name of Object.keys(materials)) assert.ok(sizeOf(shaderOf(name)) < sizeOf(all));
});
