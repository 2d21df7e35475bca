import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Problem, parseScene, SceneError, sceneJsonSchema, serializeScene, shapeKinds } from '@ray-scene/core';
import { Ajv2020 } from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { arbitraryScene } from './arbitrary-scene.ts';

const problemsOf = (input: unknown): readonly Problem[] => {
  try {
    parseScene(input);
  } catch (error) {
    if (error instanceof SceneError) return error.problems;
    throw error;
  }
  return [];
};

const told = (input: unknown): string[] => problemsOf(input).map(({ where, message }) => `${where}: ${message}`);

test('a scene survives being written and read again', () => {
  fc.assert(
    fc.property(arbitraryScene, (json) => {
      const scene = parseScene(json);
      assert.deepEqual(parseScene(serializeScene(scene)), scene);
      assert.deepEqual(parseScene(JSON.stringify(serializeScene(scene))), scene);
    }),
  );
});

test('what the parser accepts in JSON form the JSON Schema accepts, and what the schema refuses the parser refuses', () => {
  const validate = new Ajv2020({ strict: true, strictTypes: false }).compile(sceneJsonSchema());
  fc.assert(
    fc.property(arbitraryScene, (json) => {
      parseScene(json);
      assert.ok(validate(json), JSON.stringify(validate.errors));
    }),
  );
  fc.assert(
    fc.property(arbitraryScene, fc.string({ minLength: 1 }), fc.anything({ maxDepth: 1 }), (json, key, value) => {
      const broken = JSON.parse(JSON.stringify({ ...json, [key]: value ?? null }));
      if (problemsOf(broken).length === 0) assert.ok(validate(broken), JSON.stringify(validate.errors));
    }),
  );
});

test('any value may be the text that it has in markup', () => {
  const asText = parseScene({ objects: [{ type: 'sphere', center: '0, 1 -2e0', radius: ' 2 ', roughness: '0.5' }] });
  const asJson = parseScene({ objects: [{ type: 'sphere', center: [0, 1, -2], radius: 2, roughness: 0.5 }] });
  assert.deepEqual(asText, asJson);
});

test('colours are linear Rec. 709', () => {
  const colorOf = (color: unknown) => parseScene({ materials: { a: { color } } }).materials.a?.color;
  assert.deepEqual(colorOf('white'), [1, 1, 1]);
  assert.deepEqual(colorOf('color(srgb-linear 0.25 0.5 0)'), [0.25, 0.5, 0]);
  assert.deepEqual(colorOf([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
  const [grey] = colorOf('#808080') ?? [];
  assert.ok(Math.abs((grey ?? 0) - ((128 / 255 + 0.055) / 1.055) ** 2.4) < 1e-12);
});

const messages: readonly [what: string, scene: unknown, told: readonly string[]][] = [
  [
    'a misspelt key',
    { objects: [{ type: 'sphere', raduis: 2 }] },
    [
      'objects[0]: unknown key "raduis" (did you mean "radius"?). A sphere takes: center, radius, name, material, color, ' +
        'metalness, roughness, ior, specular, specularColor, transmission, attenuationColor, attenuationDistance, ' +
        'emission, emissionIntensity, emissionSide, checker, checkerSize, map.',
    ],
  ],
  [
    'an unknown kind',
    { objects: [{ type: 'spere' }] },
    [`objects[0]: unknown type "spere" (did you mean "sphere"?). Types of object: ${shapeKinds.join(', ')}, group.`],
  ],
  [
    'a negative radius',
    { objects: [{ type: 'sphere', radius: -1 }] },
    ['objects[0]: radius must be a number above 0, not -1'],
  ],
  [
    'a NaN',
    { objects: [{ type: 'sphere', radius: Number.NaN }] },
    ['objects[0]: radius must be a number above 0, not NaN'],
  ],
  [
    'a number that is a word',
    { camera: { fov: 'wide' } },
    ['camera: fov must be a number from 0.000001 to 179, not "wide"'],
  ],
  [
    'a missing material',
    { materials: { red: {} }, objects: [{ type: 'sphere', material: 'rd' }] },
    [
      'objects[0]: unknown material "rd" (did you mean "red"?). Materials here: red, mirror, gold, silver, copper, ' +
        'aluminium, glass, water, diamond, plaster.',
    ],
  ],
  [
    'a colour outside sRGB',
    { objects: [{ type: 'sphere', color: 'oklch(0.7 0.4 150)' }] },
    [
      'objects[0]: color must be a colour like "crimson", "#8c3", "oklch(0.7 0.1 200)" or, in JSON, linear [r, g, b], ' +
        'not "oklch(0.7 0.4 150)", which is outside the sRGB gamut',
    ],
  ],
  [
    'a newer version',
    { version: 2, spheres: [] },
    ['scene: version 2 is newer than this ray-scene, which reads version 1: load a newer ray-scene'],
  ],
  ['a list that is none', { objects: {} }, ['objects: must be a list [ … ], not {}']],
  [
    'a contradiction',
    { environment: { color: 'red', top: 'blue', bottom: 'red' } },
    ['environment: takes a color, or top and bottom, not both'],
  ],
  [
    'surroundings said twice',
    { environment: { src: 'sky.hdr', color: 'red' } },
    ['environment: takes a src or colours, not both'],
  ],
  ['an address that is none', { environment: { src: ' ' } }, ['environment: src must be an address, not " "']],
];

for (const [what, scene, expected] of messages) {
  test(`the message for ${what} says where, what, and what would be right`, () => {
    assert.deepEqual(told(scene), expected);
  });
}

test('all problems are told at once', () => {
  const scene = {
    lights: [{ type: 'pont' }, { intensity: -1 }],
    objects: [{ type: 'sphere', radius: 0, colour: 'red' }],
  };
  assert.equal(problemsOf(scene).length, 4);
});

test('broken JSON is one problem', () => {
  assert.match(told('{"objects": [}').join('\n'), /^scene: is not JSON: /);
});

test('whatever the input, the answer is a scene or a SceneError', () => {
  fc.assert(fc.property(fc.anything(), (input) => void problemsOf(input)));
  fc.assert(fc.property(fc.json(), (input) => void problemsOf(input)));
});

test('a parsed scene is frozen to its leaves', () => {
  const scene = parseScene({ objects: [{ type: 'sphere' }], extras: { a: [1] } });
  assert.ok(Object.isFrozen(scene.objects[0]?.type === 'sphere' && scene.objects[0].center));
  assert.ok(Object.isFrozen((scene.extras as { a: number[] }).a));
});

test('lengths of a scene may be 1e13 times others, and no more', () => {
  const beside = (other: object, rest: object = {}): string[] =>
    told({ objects: [{ type: 'sphere' }, other], ...rest });
  assert.deepEqual(beside({ type: 'sphere', center: [0, -9e12, 0], radius: 9e12 }), []);
  assert.deepEqual(beside({ type: 'sphere', center: [0, -2e13, 0], radius: 2e13 }), [
    'objects[0]: has a length of 1, and objects[1] one of 20000000000000: in one scene, none may be 1e13 times another',
  ]);
  assert.deepEqual(beside({ type: 'torus', center: [0, 0, 30], tube: 1e-12 }), [
    'objects[1]: has a length of 1e-12, and objects[1] one of 30: in one scene, none may be 1e13 times another',
  ]);
  assert.deepEqual(beside({ type: 'sphere', radius: 1e-9 }, { camera: { position: [0, 3e4, 4e4] } }), [
    'objects[1]: has a length of 1e-9, and camera one of 50000: in one scene, none may be 1e13 times another',
  ]);
  assert.deepEqual(beside({ type: 'plane' }, { lights: [{ position: [0, 1e14, 0] }] }), [
    'objects[0]: has a length of 1, and lights[0] one of 100000000000000: in one scene, none may be 1e13 times another',
  ]);
});

test('what groups do to lengths counts, and coordinates next to 0 do not', () => {
  const ball = { type: 'sphere', radius: 0.5, center: [6e-17, 1, 0] };
  const group = (scale: unknown, ...objects: object[]): object => ({ type: 'group', scale, objects });
  assert.deepEqual(told({ objects: [group(1e-9, ball), { type: 'plane', point: [0, -1e3, 0] }] }), []);
  assert.deepEqual(
    told({ objects: [group([1e-6, 1, 1], group(1e-6, ball)), { type: 'plane', point: [0, -1e3, 0] }] }),
    [
      'objects[0].objects[0].objects[0]: has a length of 5e-13, and objects[1] one of 1000: in one scene, none may be 1e13 ' +
        'times another',
    ],
  );
});

test('whether lengths fit together does not depend on the unit', () => {
  fc.assert(
    fc.property(fc.double({ min: 1e11, max: 1e15 }), fc.integer({ min: -40, max: 40 }), (ratio, exponent) => {
      const unit = 10 ** exponent;
      const objects = [
        { type: 'sphere', radius: unit },
        { type: 'box', size: [unit, ratio * unit, 2 * unit] },
      ];
      fc.pre(Math.abs(ratio / 1e13 - 1) > 1e-9);
      assert.equal(told({ objects }).length, ratio > 1e13 ? 1 : 0);
    }),
  );
});
