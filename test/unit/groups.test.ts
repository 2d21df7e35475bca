// Groups: what is refused, where their members end up, and that rays meet them there.
import '@ray-scene/core/parts';
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { intersect, parseScene, resolveScene, SceneError, serializeScene, type Vec3 } from '@ray-scene/core';
import fc from 'fast-check';
import { Affine } from '../../packages/core/src/affine.ts';
import { add, dot, length, normalize, scale, subtract } from '../../packages/core/src/vector.ts';

const told = (scene: unknown): string[] => {
  try {
    parseScene(scene);
  } catch (error) {
    if (error instanceof SceneError) return error.problems.map(({ where, message }) => `${where}: ${message}`);
    throw error;
  }
  return [];
};

const nested = (depth: number): object =>
  depth === 0 ? { type: 'sphere' } : { type: 'group', objects: [nested(depth - 1)] };

const factorsMessage = 'must be one number or three "x y z", each from 1e-12 to 1e12 or the negative of that';

const messages: readonly [what: string, scene: object, told: readonly string[]][] = [
  [
    'a misspelt key in a group in a group',
    {
      objects: [
        { type: 'group', objects: [{ type: 'sphere' }, { type: 'group', objects: [{ type: 'sphere', raduis: 1 }] }] },
      ],
    },
    [],
  ],
  [
    'a key that groups do not have',
    { objects: [{ type: 'group', translate: [1, 0, 0] }] },
    ['objects[0]: unknown key "translate". A group takes: name, position, rotation, scale, lights, objects.'],
  ],
  [
    'a scale that makes nothing of an axis',
    { objects: [{ type: 'group', scale: [1, 0, 1] }] },
    [`objects[0]: scale ${factorsMessage}, not [1,0,1]`],
  ],
  [
    'a scale that is too much with that around it',
    { objects: [{ type: 'group', scale: 1e7, objects: [{ type: 'group', scale: 1e7 }] }] },
    [
      'objects[0].objects[0]: scale, with that of the groups around it, must stay from 1e-12 to 1e12, and none 1e12 ' +
        'times another',
    ],
  ],
  [
    'a member that is none',
    { objects: [{ type: 'group', objects: {}, lights: [{ type: 'pont' }] }] },
    [
      'objects[0].lights[0]: unknown type "pont" (did you mean "point"?). Types of light: point, spot, directional.',
      'objects[0]: must be a list [ … ], not {}',
    ],
  ],
  [
    'groups too deep in each other',
    { objects: [nested(17)] },
    [`objects[0]${'.objects[0]'.repeat(16)}: groups may stand in each other 16 deep`],
  ],
  [
    'more objects than a scene may hold, in groups',
    { objects: Array.from({ length: 600 }, () => ({ type: 'group', objects: [{ type: 'sphere' }] })) },
    ['objects: a scene may hold 1024 objects, this one has 1024'],
  ],
];

for (const [what, scene, expected] of messages.slice(1, 6)) {
  test(`the message for ${what} says where, what, and what would be right`, () => {
    assert.deepEqual(told(scene), expected);
  });
}

test('a problem in a group is told with the way there', () => {
  const [first = ''] = told(messages[0]?.[1]);
  assert.match(first, /^objects\[0\]\.objects\[1\]\.objects\[0\]: unknown key "raduis" \(did you mean "radius"\?\)/);
});

test('objects in groups count, as groups do; a group that holds itself ends somewhere', () => {
  assert.match(told(messages[6]?.[1]).join(), /^objects: a scene may hold 1024 objects, this one has \d+$/);
  const group: { type: string; objects: unknown[] } = { type: 'group', objects: [] };
  group.objects.push(group, group);
  assert.ok(told({ objects: [group] }).length > 0);
});

test('a material that a group does not know of is told', () => {
  const scene = { objects: [{ type: 'group', objects: [{ type: 'sphere', material: 'god' }] }] };
  assert.match(told(scene).join(), /^objects\[0\]\.objects\[0\]: unknown material "god" \(did you mean "gold"\?\)/);
});

const number = fc.double({ min: -3, max: 3, noNaN: true }).map((x) => Number(x.toFixed(3)));
const triple = fc.tuple(number, number, number);
const factor = fc.constantFrom(-2, -1, -0.5, 0.25, 1, 1.5, 3);
const group = fc.record({
  position: triple,
  rotation: fc.oneof(
    triple.map((v) => scale(v, 60)),
    fc.constantFrom([0, 90, 0], [180, 0, -90], [0, 0, 0]),
  ),
  scale: fc.oneof(
    factor.map((s): Vec3 => [s, s, s]),
    fc.tuple(factor, factor, factor),
  ),
});

const shapes = fc.constantFrom(
  { type: 'sphere', center: [0.2, 0, 0] },
  { type: 'plane', normal: [1, 2, 0] },
  { type: 'disc', normal: [0, 1, 1] },
  { type: 'disc' },
  { type: 'quad' },
  { type: 'box', size: [1, 2, 0.5] },
  { type: 'cylinder' },
  { type: 'cylinder', top: [1, 2, 0] },
  { type: 'cone' },
  { type: 'torus' },
  { type: 'triangle' },
);

const maps = fc.array(group, { minLength: 1, maxLength: 3 });

const affineOf = (groups: readonly { position: Vec3; rotation: Vec3; scale: Vec3 }[]): Affine =>
  groups.reduce((map, one) => map.within(one), Affine.identity);

/** A scene of groups in each other, the last of which has these members. */
function inGroups(groups: readonly object[], members: object): object {
  let inside = members;
  for (const one of [...groups].reverse()) inside = { objects: [{ type: 'group', ...one, ...inside }] };
  return inside;
}

test('a ray meets the member of a group where the ray that is mapped back meets it outside of any', () => {
  fc.assert(
    fc.property(maps, shapes, fc.boolean(), triple, triple, (groups, shape, checkered, origin, target) => {
      const map = affineOf(groups as Parameters<typeof affineOf>[0]);
      const direction = subtract(map.point(scale(target as Vec3, 0.2)), origin as Vec3);
      if (length(direction) < 1e-3) return;
      const object = checkered ? { ...shape, checker: 'red' } : shape;
      const scene = inGroups(groups, { objects: [object] });
      const hit = intersect(parseScene(scene), { origin: origin as Vec3, direction });
      const alone = parseScene({ objects: [object] });
      const [start, ahead] = [map.pointBack(origin as Vec3), map.directionBack(direction)];
      const own = intersect(alone, { origin: start, direction: ahead });
      // Whoever grazes may be on either side of an edge.
      const cosine = own ? Math.abs(dot(own.normal, normalize(ahead))) : 0;
      if (!hit !== !own || (own && cosine < 1e-3)) return;
      if (!hit || !own) return;
      // So may who meets the edge itself: the normal beside it is another one.
      const isEdge = [1, -1].some((side) => {
        const aside = scale([1, 2, 3], side * 1e-7 * length(ahead));
        const beside = intersect(alone, { origin: start, direction: add(ahead, aside) });
        return !beside || dot(beside.normal, own.normal) < 0.99;
      });
      if (isEdge) return;
      assert.ok(Math.abs(hit.t / own.t - 1) < 1e-6, `${hit.t} ${own.t}`);
      const normal = normalize(map.normal(own.normal));
      assert.ok(Math.abs(dot(normal, hit.normal) - 1) < 1e-6, 'the same side is outside, or the front');
      assert.equal(hit.path.length, groups.length + 1);
    }),
    { numRuns: 1000 },
  );
});

test('hits and misses are those of the ray that is mapped back, but at edges', () => {
  let different = 0;
  const runs = 1000;
  fc.assert(
    fc.property(maps, shapes, triple, triple, (groups, shape, origin, target) => {
      const map = affineOf(groups as Parameters<typeof affineOf>[0]);
      const direction = subtract(map.point(scale(target as Vec3, 0.2)), origin as Vec3);
      if (length(direction) < 1e-3) return;
      const scene = inGroups(groups, { objects: [shape] });
      const back = { origin: map.pointBack(origin as Vec3), direction: map.directionBack(direction) };
      const hit = intersect(parseScene(scene), { origin: origin as Vec3, direction });
      if (!hit !== !intersect(parseScene({ objects: [shape] }), back)) different++;
    }),
    { numRuns: runs },
  );
  assert.ok(different <= runs / 100, `${different}`);
});

test('the inverse of a map undoes it', () => {
  fc.assert(
    fc.property(maps, triple, (groups, point) => {
      const map = affineOf(groups as Parameters<typeof affineOf>[0]);
      const back = map.pointBack(map.point(point as Vec3));
      assert.ok(length(subtract(back, point as Vec3)) < 1e-10);
    }),
  );
});

test('turns are about x, then the new y axis, then the new z axis; right angles are exact', () => {
  const turned = (rotation: Vec3, v: Vec3): Vec3 =>
    Affine.identity
      .within({ position: [0, 0, 0], rotation, scale: [1, 1, 1] })
      .direction(v)
      .map((x) => x + 0) as unknown as Vec3;
  assert.deepEqual(turned([90, 0, 0], [0, 1, 0]), [0, 0, 1]);
  assert.deepEqual(turned([0, 90, 0], [0, 0, 1]), [1, 0, 0]);
  assert.deepEqual(turned([0, 0, 90], [1, 0, 0]), [0, 1, 0]);
  assert.deepEqual(turned([90, 90, 0], [1, 0, 0]), [0, 1, 0]);
  assert.deepEqual(turned([-270, 0, 720], [0, 1, 0]), [0, 0, 1]);
});

const kindOf = (groupFields: object, object: object): string => {
  const scene = parseScene({ objects: [{ type: 'group', ...groupFields, objects: [object] }] });
  const [member] = resolveScene(scene).objects;
  return `${member?.shape.type}${member?.shape.place ? ' in its own space' : ''}`;
};

test('shapes that are still of their kind say themselves where they are', () => {
  const turn = { rotation: [10, 20, 30] };
  const stretch = { scale: [1, 2, 3] };
  for (const type of ['plane', 'quad', 'triangle']) assert.equal(kindOf({ ...turn, ...stretch }, { type }), type);
  for (const type of ['sphere', 'disc', 'cylinder', 'cone', 'torus']) {
    assert.equal(kindOf({ ...turn, scale: -2 }, { type }), type);
    assert.equal(kindOf(stretch, { type }), `${type} in its own space`);
  }
  for (const type of ['disc', 'cylinder', 'cone']) assert.equal(kindOf({ ...turn, scale: [2, 5, 2] }, { type }), type);
  assert.equal(kindOf({ rotation: [90, 0, -180], ...stretch }, { type: 'box' }), 'box');
  assert.equal(kindOf(turn, { type: 'box' }), 'box in its own space');
  assert.equal(kindOf(turn, { type: 'sphere', checker: 'red' }), 'sphere in its own space');
  assert.equal(kindOf({ scale: 2 }, { type: 'sphere', checker: 'red' }), 'sphere');
});

test('lights go along with their group, and are as bright as before', () => {
  const members = { lights: [{ type: 'point', intensity: 7 }, { type: 'directional' }, { type: 'spot', radius: 0.5 }] };
  const scene = parseScene({
    objects: [{ type: 'group', position: [5, 0, 0], rotation: [0, 0, 90], scale: 2, ...members }],
  });
  const [point, sun, spot] = resolveScene(scene).lights;
  assert.deepEqual(point?.type === 'point' && [point.position, point.intensity], [[3, 0, 0], 7]);
  assert.deepEqual(sun?.type === 'directional' && sun.direction, [2, 0, 0]);
  assert.deepEqual(spot?.type === 'spot' && [spot.position, spot.target, spot.radius], [[3, 0, 0], [5, 0, 0], 1]);
});

test('groups survive being written and read again', () => {
  fc.assert(
    fc.property(maps, shapes, (groups, shape) => {
      const scene = parseScene(inGroups(groups, { objects: [shape], lights: [{ type: 'point' }] }));
      assert.deepEqual(parseScene(serializeScene(scene)), scene);
    }),
  );
});
