// What each feature of a scene adds to its shader, in characters, and that no other scene's shader holds what is for it.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { before, describe, it } from 'node:test';
import { generateShader, loadPaths, parseScene, requirements, resolveScene } from '@ray-scene/core';
import { type FeatureScene, featureScenes, images } from '../feature-scenes.ts';

/** Without white space. */
function shaderOf({ scene, settings }: FeatureScene): string {
  const resolved = resolveScene(parseScene(scene), 1, undefined, images);
  const tracing = { bounces: 3, integrator: 'path', ...settings } as const;
  return generateShader(requirements(resolved, tracing)).fragment.replace(/\s+/g, ' ');
}

const sizeOf = (text: string): number => text.replace(/\s/g, '').length;

const holds = (text: string, word: string): boolean => new RegExp(`\\b${word.replace('.', '\\.')}\\b`).test(text);

describe('what a feature adds to the shader', () => {
  let shaders: { readonly [what: string]: string } = {};
  before(async () => {
    await loadPaths(resolveScene(parseScene({})), { integrator: 'path' });
    shaders = Object.fromEntries(Object.entries(featureScenes).map(([what, row]) => [what, shaderOf(row)]));
  });

  it('is there for it, and in no shader that does without', () => {
    const words = new Set(Object.values(featureScenes).flatMap((row) => row.holds));
    const wrong = Object.entries(featureScenes).flatMap(([what, row]) =>
      [...words]
        .filter((word) => holds(shaders[what] as string, word) !== row.holds.includes(word))
        .map((word) => `${what}: ${word}`),
    );
    assert.deepEqual(wrong, []);
  });

  it('has so many characters', (t) => {
    const [[, first] = ['', ''], ...others] = Object.entries(shaders);
    const base = sizeOf(first);
    const lines = others.map(([what, text]) => `${what.padEnd(36)} ${String(sizeOf(text) - base).padStart(6)}`);
    t.diagnostic(`characters: a dull ball and a lamp ${base}; what is added to that\n${lines.join('\n')}`);
    assert.ok(base <= 8200, `${base}`);
    for (const [what, text] of others) assert.ok(sizeOf(text) - base < 8000, `${what}: ${sizeOf(text) - base}`);
  });
});
