// Images on surfaces: where on an image a point of each shape is, and that it is where the documentation says.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parseScene, type Vec3 } from '@ray-scene/core';
import { renderReference } from '@ray-scene/core/reference';
import { mapped } from '../../packages/core/src/reference/image-map.ts';
import { resolveScene } from '../../packages/core/src/resolve-scene.ts';

/** Red tells u and green tells v of the middle of a texel; blue is 1. */
const WIDTH = 64;
const HEIGHT = 32;
const chart = {
  width: WIDTH,
  height: HEIGHT,
  data: Float32Array.from({ length: 3 * WIDTH * HEIGHT }, (_, k) => {
    const texel = Math.floor(k / 3);
    return [((texel % WIDTH) + 0.5) / WIDTH, 1 - (Math.floor(texel / WIDTH) + 0.5) / HEIGHT, 1][k % 3] as number;
  }),
};
const images = new Map([['chart.png', chart]]);

/** Where on its image an object is at a point of it. */
function placeAt(object: object, point: Vec3): readonly [number, number] {
  const scene = resolveScene(parseScene({ objects: [{ ...object, map: 'chart.png' }] }), 1, undefined, images);
  const [u, v] = mapped(scene, 0, point, [1, 1, 1]);
  return [u, v];
}

const near = ([a, b]: readonly [number, number], [c, d]: readonly [number, number]): boolean =>
  Math.abs(a - c) < 1e-6 && Math.abs(b - d) < 1e-6;

const tilted = Math.SQRT1_2;

/** A point of each shape, and where on the image that is. Not at the edges, where one is halfway to the first texel. */
const places: readonly (readonly [what: string, object: object, point: Vec3, uv: readonly [number, number]])[] = [
  ['sphere, towards +x', { type: 'sphere', center: [1, 2, 3], radius: 2 }, [3, 2, 3], [0.25, 0.5]],
  ['sphere, between -z and +y', { type: 'sphere' }, [0, tilted, -tilted], [0.5, 0.75]],
  ['plane', { type: 'plane', checkerSize: 2 }, [0.5, 0, -1.5], [0.25, 0.75]],
  ['plane, further on', { type: 'plane', checkerSize: 2 }, [-7.5, 0, 10.5], [0.25, 0.75]],
  ['disc', { type: 'disc', radius: 2 }, [1, 0, -1], [0.75, 0.75]],
  ['quad', { type: 'quad', corner: [1, 1, 1], edgeU: [4, 0, 0], edgeV: [1, 2, 0] }, [2.75, 2.5, 1], [0.25, 0.75]],
  ['triangle', { type: 'triangle', a: [0, 0, 0], b: [4, 0, 0], c: [0, 8, 0] }, [1, 4, 0], [0.25, 0.5]],
  ['box, its front', { type: 'box', center: [1, 1, 1], size: [2, 4, 8] }, [1.5, 0, 5], [0.75, 0.25]],
  ['box, its right side', { type: 'box', center: [1, 1, 1], size: [2, 4, 8] }, [2, 2, -1], [0.25, 0.75]],
  ['box, its top', { type: 'box', center: [1, 1, 1], size: [2, 4, 8] }, [0.5, 3, -1], [0.25, 0.25]],
  ['cylinder, its side', { type: 'cylinder', radius: 2, base: [0, 0, 0], top: [0, 4, 0] }, [0, 1, -2], [0.25, 0.25]],
  ['cylinder, a cap', { type: 'cylinder', radius: 2, base: [0, 0, 0], top: [0, 4, 0] }, [1, 4, -1], [0.75, 0.75]],
  ['cone, its side', { type: 'cone', radius: 2, base: [0, 0, 0], tip: [0, 4, 0] }, [-1.5, 1, 0], [0.5, 0.25]],
  ['cone, its base', { type: 'cone', radius: 2, base: [0, 0, 0], tip: [0, 4, 0] }, [1, 0, 1], [0.75, 0.25]],
  ['torus, its top', { type: 'torus', radius: 2, tube: 0.5 }, [0, 0.5, -2], [0.25, 0.25]],
];

describe('images on surfaces', () => {
  for (const [what, object, point, uv] of places) {
    it(`${what}: (u, v) = (${uv.join(', ')})`, () => {
      const place = placeAt(object, point);
      assert.ok(near(place, uv), `${place}`);
    });
  }

  it('go with what a group does to its objects', () => {
    const { shape, material } = { shape: { type: 'box', size: [1, 1, 1] }, material: { map: 'chart.png' } };
    const group = { type: 'group', position: [10, 0, 0], scale: [2, 4, 8], rotation: [0, 30, 0] };
    const scene = resolveScene(
      parseScene({ objects: [{ ...group, objects: [{ ...shape, ...material }] }] }),
      1,
      undefined,
      images,
    );
    // The front's point (0.25, -0.25, 0.5) of the box.
    const [x, y, z] = [0.5, -1, 4];
    const [cos, sin] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
    const [u, v] = mapped(scene, 0, [10 + cos * x + sin * z, y, -sin * x + cos * z], [1, 1, 1]);
    assert.ok(near([u, v], [0.75, 0.25]), `${u}, ${v}`);
  });

  it('multiply the colour, of a checker too, and of a material that several share', () => {
    const scene = resolveScene(
      parseScene({
        materials: { paper: { map: 'chart.png', color: [0.5, 1, 0.25], checker: [0, 0, 1] } },
        objects: [
          { type: 'quad', corner: [0, 0, 0], edgeU: [2, 0, 0], edgeV: [0, 2, 0], material: 'paper' },
          { type: 'quad', corner: [0, 0, -1], edgeU: [4, 0, 0], edgeV: [0, 4, 0], material: 'paper' },
        ],
      }),
      1,
      undefined,
      images,
    );
    assert.equal(scene.materials.length, 2);
    const [r, g, b] = mapped(scene, 1, [1, 1, -1], [0.5, 1, 0.25]);
    assert.ok(near([r, g], [0.125, 0.25]) && Math.abs(b - 0.25) < 1e-6);
  });

  it('that are not handed in change nothing', () => {
    const scene = parseScene({ camera: { position: [0, 0, 5] }, objects: [{ type: 'sphere', map: 'chart.png' }] });
    const settings = { width: 8, height: 8, samples: 1, output: 'albedo' } as const;
    const without = renderReference(scene, settings);
    assert.ok(without.data.every((value) => value === 0 || value === 1));
    const { data } = renderReference(scene, { ...settings, images });
    assert.ok(data.some((value) => value > 0 && value < 1));
  });
});
