// Shapes that have lost a dimension are refused; those that have nearly lost one are drawn in finite numbers.
import { expect } from '@open-wc/testing';
import { parseScene } from '@ray-scene/core';
import { drawn } from '../browser/drawn.ts';

const refused: readonly [object, RegExp][] = [
  [{ type: 'sphere', radius: 0 }, /radius must be a number above 0/],
  [{ type: 'sphere', radius: 1e-61 }, /radius must be a number above 0/],
  [{ type: 'disc', radius: 0 }, /radius must be a number above 0/],
  [{ type: 'disc', normal: [0, 0, 0] }, /normal must be three numbers .*, not all 0/],
  [{ type: 'disc', normal: [1, 1, 0], tangent: [2, 2, 0] }, /tangent must not be parallel/],
  [{ type: 'plane', normal: [0, 0, 0] }, /normal must be three numbers .*, not all 0/],
  [{ type: 'quad', edgeU: [1, 2, 3], edgeV: [-2, -4, -6] }, /no area/],
  [{ type: 'quad', edgeU: [0, 0, 0] }, /edgeU must be three numbers .*, not all 0/],
  [{ type: 'box', size: [1, 0, 1] }, /size must be three numbers .* above 0/],
  [{ type: 'cylinder', base: [1, 1, 1], top: [1, 1, 1] }, /no height/],
  [{ type: 'cylinder', radius: 0 }, /radius must be a number above 0/],
  [{ type: 'cone', base: [1, 1, 1], tip: [1, 1, 1] }, /no height/],
  [{ type: 'torus', radius: 1, tube: 1 }, /tube must be below the radius/],
  [{ type: 'torus', tube: 0 }, /tube must be a number above 0/],
  [{ type: 'triangle', a: [0, 0, 0], b: [1, 2, 3], c: [2, 4, 6] }, /there is no area/],
  [{ type: 'sphere', radius: 1e-59 }, /none may be 1e13 times another/],
  [{ type: 'box', size: [1, 1e-59, 1] }, /none may be 1e13 times another/],
  [{ type: 'cylinder', base: [0, 0, 0], top: [0, 1e-30, 0] }, /none may be 1e13 times another/],
  [{ type: 'quad', edgeU: [1e20, 0, 0], edgeV: [0, 1e-20, 0] }, /none may be 1e13 times another/],
  [{ type: 'triangle', a: [1, 1, 1], b: [1, 1, 1], c: [2, 4, 6] }, /there is no area/],
];

/** Just within what is accepted. */
const nearly: { readonly [what: string]: object } = {
  'a sphere of hardly any radius': { type: 'sphere', radius: 1e-12 },
  'a huge sphere': { type: 'sphere', center: [0, -4e12, 0], radius: 4e12 },
  'a thin box': { type: 'box', size: [1, 1e-12, 1] },
  'a box that is a line': { type: 'box', size: [1e-12, 1, 1e-12] },
  'a flat cylinder': { type: 'cylinder', base: [0, 0, 0], top: [0, 1e-12, 0] },
  'a cylinder that is a line': { type: 'cylinder', radius: 1e-12 },
  'a flat cone': { type: 'cone', base: [0, 0, 0], tip: [0, 1e-12, 0] },
  'a cone that is a line': { type: 'cone', radius: 1e-12 },
  'a ring that is a line': { type: 'torus', tube: 1e-12 },
  'a ring that nearly closes': { type: 'torus', radius: 1, tube: 1 - 1e-15 },
  'a sliver': { type: 'triangle', a: [0, 0, 0], b: [1, 0, 0], c: [2, 1e-12, 0] },
  'a quad of nearly parallel edges': { type: 'quad', edgeU: [1, 0, 0], edgeV: [1, 1e-12, 0] },
  'a quad of very different edges': { type: 'quad', edgeU: [2e6, 0, 0], edgeV: [0, 1e-6, 0] },
  'a disc that is a point': { type: 'disc', radius: 1e-12 },
};

describe('degenerate primitives', function () {
  this.timeout(60_000);

  for (const [shape, message] of refused) {
    it(`are refused: ${JSON.stringify(shape)}`, () => {
      const scene = { camera: { position: [0.3, 0.5, 3] }, objects: [shape] };
      expect(() => parseScene(scene)).to.throw(message);
    });
  }

  for (const [what, shape] of Object.entries(nearly)) {
    it(`${what} gives finite pixels`, () => {
      const scene = parseScene({
        camera: { position: [0.3, 0.5, 3] },
        lights: [{ type: 'point', position: [2, 3, 4], intensity: 30 }],
        environment: { color: 'white' },
        objects: [
          { ...shape, checker: 'black' },
          { type: 'sphere', center: [0.5, 0, -1], radius: 0.5 },
        ],
      });
      const picture = drawn(scene, { width: 24, height: 24, bounces: 4, samples: 1 });
      expect([...picture].filter((value) => !(value >= 0 && value < 3.4e38))).to.deep.equal([]);
    });
  }
});
