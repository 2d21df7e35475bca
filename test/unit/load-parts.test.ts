import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { suite, test } from 'node:test';
// Not the package's index, whose reference tracer knows all shapes from the start.
import { generateShader } from '../../packages/core/src/generate-shader.ts';
import { loadShaderParts, loadShapes, loadWords } from '../../packages/core/src/load-parts.ts';
import { packScene } from '../../packages/core/src/pack-scene.ts';
import { parseScene } from '../../packages/core/src/parse-scene.ts';
import { requirements } from '../../packages/core/src/requirements.ts';
import { resolveScene } from '../../packages/core/src/resolve-scene.ts';
import { SceneError } from '../../packages/core/src/scene-error.ts';
import type { Scene } from '../../packages/core/src/schema.ts';

/** What is parsed of a colour before those of CSS are loaded. */
const early = ['black', '#8c3', 'color(srgb-linear 0 0.1 0)', 'rgb(1 2 3)', 'crimson', 'oklch(0.7 0.1 200)'].map(
  (color) => {
    try {
      return [color, parseScene({ background: color }).background] as const;
    } catch (error) {
      return [color, error] as const;
    }
  },
);
const loading = loadWords();
await loading;

const example = (name: string): Scene =>
  parseScene(readFileSync(new URL(`../../examples/scenes/${name}.json`, import.meta.url), 'utf8'));

const required = (scene: Scene) => requirements(resolveScene(scene), { bounces: 6 });

const sphere = { type: 'sphere' };

const simple = {
  'the classic': example('classic'),
  hello: example('hello'),
  'an empty room with a lamp': parseScene({ lights: [{ type: 'point' }] }),
};

const demanding = {
  'a ball in the studio': parseScene({ objects: [sphere] }),
  'a ball in the sun': parseScene({ lights: [{ type: 'directional' }], objects: [sphere] }),
  'a ball under a sky': parseScene({ environment: {}, lights: [{ type: 'point' }], objects: [sphere] }),
  'a checkered ball': parseScene({ objects: [{ ...sphere, checker: 'red' }] }),
  'a plane that is not level': parseScene({ objects: [{ type: 'plane', normal: [1, 1, 0] }] }),
  'a camera in a ball': parseScene({ camera: { position: [0, 0, 0.5] }, objects: [sphere] }),
  'a camera next to a planet': parseScene({ camera: { position: [0, 1.0001, 0] }, objects: [sphere] }),
  'many balls': parseScene({ objects: Array.from({ length: 9 }, () => sphere) }),
};

suite('what a page loads', () => {
  test('colours that need no table are read at once, others when the colours of CSS are there', () => {
    assert.ok(loading instanceof Promise);
    assert.equal(loadWords(), undefined);
    assert.deepEqual(
      early.filter(([, read]) => read instanceof SceneError).map(([color]) => color),
      ['rgb(1 2 3)', 'crimson', 'oklch(0.7 0.1 200)'],
    );
    for (const [color, read] of early) {
      const { background } = parseScene({ background: color });
      if (!(read instanceof SceneError)) assert.deepEqual(read, background, color);
    }
  });

  for (const [name, scene] of Object.entries(simple)) {
    test(`${name} is drawn without another file`, () => {
      assert.equal(loadShapes(scene), undefined);
      assert.equal(loadShaderParts(required(scene)), undefined);
      const { sceneBlock } = generateShader(required(scene));
      assert.equal(packScene(resolveScene(scene), required(scene), sceneBlock).byteLength, sceneBlock.size);
    });
  }

  test('other scenes wait for more, and are drawn when it is there', async () => {
    const torus = parseScene({ objects: [{ type: 'torus' }] });
    assert.throws(() => required(torus), /is not loaded/);
    const scenes = Object.entries(demanding).map(([name, scene]) => [name, required(scene)] as const);
    for (const [name, requirements] of scenes) {
      assert.throws(() => generateShader(requirements), /no shader file|is not loaded/, name);
    }
    const loading = [
      loadShapes(torus),
      loadShaderParts(required(simple.hello), { varyings: 30 }),
      ...scenes.map(([, requirements]) => loadShaderParts(requirements)),
    ];
    for (const promise of loading) assert.ok(promise instanceof Promise);
    await Promise.all(loading);
    assert.equal(loadShaderParts(required(torus)), undefined);
    for (const requirements of [required(torus), ...scenes.map(([, one]) => one)]) generateShader(requirements);
  });
});
