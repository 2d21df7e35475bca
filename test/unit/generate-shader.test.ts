import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { features, generateShader, parseScene, requirements, resolveScene, type ShaderOptions } from '@ray-scene/core';
import { glslName } from '../../packages/core/src/generate-shader.ts';

/** Without comments, of which there are none left, and white space. */
const stripped = (glsl: string): string => glsl.replace(/\/\/.*/g, '').replace(/\s+/g, '');

const shaderOf = (scene: unknown, bounces = 6, options: ShaderOptions = {}): string =>
  generateShader(requirements(resolveScene(parseScene(scene)), { bounces }), options).fragment;

const classic = readFileSync(new URL('../../examples/scenes/classic.json', import.meta.url), 'utf8');
const sphere = { type: 'sphere', specular: 0 };
const sun = { type: 'directional', direction: [0, -1, 0] };
const simple = { background: [0, 0, 0], lights: [sun], objects: [sphere] };

for (const varyings of [0, 31]) {
  test(`the shaders of the classic and of one dull sphere keep their size, ${varyings} varyings`, (t) => {
    const sizes = [shaderOf(classic, 10, { varyings }), shaderOf(simple, 6, { varyings })].map(
      (s) => stripped(s).length,
    );
    t.diagnostic(`classic ${sizes[0]} characters, one sphere and one directional light ${sizes[1]}`);
    assert.ok((sizes[0] as number) <= 9000, `classic: ${sizes[0]}`);
    assert.ok((sizes[1] as number) <= 5000, `one sphere: ${sizes[1]}`);
  });
}

test('shader files ask for nothing but features, and the few names that are made of numbers', () => {
  const others = ['POINT_LIGHTS', 'DIRECTIONAL_LIGHTS', 'LIGHTS', 'VARYINGS', 'TONE_MAPPING_NEUTRAL'];
  const known = new Set([...features.map(glslName), ...others]);
  const folder = new URL('../../shaders/', import.meta.url);
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((one) =>
    one.endsWith('.glsl'),
  )) {
    const conditions = readFileSync(new URL(file, folder), 'utf8').match(/^#\s*(if|ifdef|ifndef|elif)\b.*/gm) ?? [];
    for (const name of conditions.join(' ').match(/\b[A-Z][A-Z0-9_]+\b/g) ?? [])
      assert.ok(known.has(name), `${file}: ${name}`);
  }
});

/** Functions of a shader besides main, in order. */
const functions = (glsl: string): string[] =>
  [...glsl.matchAll(/^\w+ (\w+)\([^;]*\) \{$/gm)].map(([, name]) => name as string).filter((name) => name !== 'main');

/** Functions that are defined and never called. */
const unused = (glsl: string): string[] =>
  functions(glsl).filter((name) => [...glsl.matchAll(new RegExp(`\\b${name}\\(`, 'g'))].length < 2);

const lamp = { type: 'point', position: [0, 4, 0] };
const floor = { type: 'plane', point: [0, -1, 0] };

const ALWAYS = [
  'cameraRay',
  'loadParts',
  'nearest',
  'fromPoint',
  'fromCamera',
  'normalAt',
  'materialAt',
  'surfaceAt',
  'background',
  'lightFrom',
  'direct',
];
const REFLECTIVE = ['schlickWeight', 'dielectricFresnel', 'fresnel', 'diffuseShare', 'ggxLobe'];
const SPHERE = ['sphereFrom', 'sphereFromCamera', 'sphereChord', 'sphereDistance', 'sphereNormal'];
const PLANE = ['planeFrom', 'planeFromCamera', 'planeDistance', 'planeNormal'];
const LIT = ['scattered', 'lightAt'];

/** What each scene's shader holds, besides `ALWAYS`: nothing more, nothing less. */
const table: readonly [what: string, scene: object, holds: readonly string[]][] = [
  ['one dull sphere and a directional light', simple, [...SPHERE, ...LIT, 'directionalLight']],
  ['a point light', { ...simple, lights: [lamp] }, [...SPHERE, ...LIT, 'pointLight']],
  [
    'two spheres: shadows',
    { ...simple, objects: [sphere, { ...sphere, radius: 2 }] },
    [...SPHERE, ...LIT, 'directionalLight', 'occlusion', 'sphereOcclusion'],
  ],
  ['a plane alone', { ...simple, objects: [{ ...floor, specular: 0 }] }, [...PLANE, ...LIT, 'directionalLight']],
  [
    'a checkered plane',
    { ...simple, objects: [{ ...floor, specular: 0, checker: 'red' }] },
    [...PLANE, ...LIT, 'directionalLight', 'planeCells', 'checkerOdd'],
  ],
  ['reflection', { ...simple, objects: [{ type: 'sphere' }] }, [...SPHERE, ...LIT, ...REFLECTIVE, 'directionalLight']],
  [
    'an environment',
    { environment: { color: 'white' }, objects: [sphere] },
    [...SPHERE, 'environmentRadiance', 'environmentIrradiance'],
  ],
];

for (const [what, scene, holds] of table) {
  test(`${what}: the shader holds what that needs, and every function is called`, () => {
    const glsl = shaderOf(scene);
    assert.deepEqual(
      functions(glsl)
        .filter((name) => !ALWAYS.includes(name))
        .sort(),
      [...holds].sort(),
    );
    assert.deepEqual(unused(glsl), []);
  });
}

test('no condition of the preprocessor reaches the driver, and every uniform is read', () => {
  for (const scene of [classic, ...table.map(([, scene]) => scene)]) {
    const glsl = shaderOf(scene);
    assert.doesNotMatch(glsl, /#\s*(if|else|endif|line)|\/\//);
    const members = [...glsl.matchAll(/^struct \w+ \{\n([^}]*)\};/gm)].flatMap(([, body]) =>
      [...(body as string).matchAll(/ (\w+);/g)].map(([, name]) => name as string),
    );
    for (const name of members) assert.match(glsl, new RegExp(`[.=] ?${name}\\b|${name}\\[`), `${name} is never read`);
  }
});

test('no text of the author gets into a shader', () => {
  const named = {
    name: 'evil',
    materials: { evil: {} },
    objects: [{ type: 'sphere', name: 'evil', material: 'evil' }],
    extras: 'evil',
  };
  assert.doesNotMatch(shaderOf(named), /evil/);
});
