// Images on surfaces: the GPU draws what the reference does, and the element loads them.
import '@ray-scene/core/parts';
import { expect } from '@open-wc/testing';
import {
  type EnvironmentImage,
  generateShader,
  parseScene,
  requirements,
  resolveScene,
  shapeKinds,
} from '@ray-scene/core';
import { illConditioned, relativeDifference, renderReference } from '@ray-scene/core/reference';
import { RenderDevice } from '../../packages/ray-scene/src/renderer.ts';
import { numbers } from '../unit/emitter-cases.ts';
import { completePicture } from './drawn.ts';
import { QuietConsole, rejection, sceneWith } from './element-fixtures.ts';

const SIZE = 64;

/** Patches of colours. */
function patches(width: number, height: number, seed: number): EnvironmentImage {
  const next = numbers(seed);
  return { width, height, data: Float32Array.from({ length: 3 * width * height }, next) };
}

const images = new Map([
  ['a', patches(16, 8, 1)],
  ['b', patches(5, 7, 2)],
  ['c', patches(1, 1, 3)],
]);

const chosen: readonly { readonly type: string; readonly [field: string]: unknown }[] = [
  { type: 'sphere' },
  { type: 'sphere', center: [0, 0, 3], radius: 8 },
  { type: 'plane', normal: [0.3, 1, 0.2], checkerSize: 0.7 },
  { type: 'disc', normal: [0, 0.4, 1] },
  { type: 'quad', corner: [-1, -1, 0], edgeU: [2, 0, 0.3], edgeV: [0.2, 2, 0] },
  { type: 'box', size: [1, 1.5, 1] },
  { type: 'cylinder', radius: 0.8 },
  { type: 'cone', radius: 1, base: [0, 1, 0], tip: [0, -0.7, 0] },
  { type: 'torus', axis: [0.2, 1, 0.4] },
  { type: 'triangle', a: [-1, -1, 0], b: [1.2, -0.8, 0.3], c: [0, 1, 0] },
];
// A kind that is new is drawn as it is by default.
const others = shapeKinds.filter((kind) => !chosen.some(({ type }) => type === kind)).map((type) => ({ type }));
const shapes = [...chosen, ...others];

const camera = { position: [0.7, 1.2, 3], target: [0, 0, 0] };
const light = { type: 'point', position: [3, 4, 5], intensity: 100 };
const scenes: { readonly [what: string]: object } = {
  ...Object.fromEntries(
    shapes.map((shape, i) => [`${shape.type} ${i}`, { camera, lights: [light], objects: [{ ...shape, map: 'a' }] }]),
  ),
  'many, some without': {
    camera,
    environment: { color: [0.5, 0.5, 0.5] },
    lights: [light],
    objects: [
      { type: 'sphere', center: [-0.7, 0, 0], radius: 0.6, map: 'b', color: [0.9, 0.5, 0.4] },
      { type: 'sphere', center: [0.8, 0, 0], radius: 0.6, map: 'a', metalness: 1, roughness: 0.3 },
      { type: 'sphere', center: [0, 0.9, 0], radius: 0.4 },
      { type: 'plane', point: [0, -0.6, 0], map: 'c', checker: 'black', checkerSize: 0.5 },
    ],
  },
  'in a space of its own': {
    camera,
    lights: [light],
    objects: [
      {
        type: 'group',
        rotation: [20, 40, 0],
        scale: [1, 0.5, 0.8],
        objects: shapes.filter((_, i) => i === 0 || i > 4).map((shape) => ({ ...shape, map: 'b' })),
      },
    ],
  },
};

describe('images on surfaces, on the GPU', function () {
  this.timeout(120_000);

  for (const [what, json] of Object.entries(scenes)) {
    for (const [integrator, output] of [
      ['path', 'beauty'],
      ['direct', 'beauty'],
      ['path', 'albedo'],
    ] as const) {
      it(`${what}, ${integrator}, ${output}: as in the reference`, async () => {
        const scene = parseScene(json);
        const settings = { width: SIZE, height: SIZE, samples: 1, bounces: 3, integrator, output } as const;
        const picture = await completePicture(scene, settings, images);
        const reference = renderReference(scene, { ...settings, images });
        const excluded = illConditioned(scene, { ...settings, images }, 1e-3, reference);
        const difference = relativeDifference(picture, reference);
        const judged = difference.filter((_, pixel) => !excluded[pixel]).sort();
        const off = judged.filter((value) => !(value <= 1e-3)).length / judged.length;
        const left = 1 - judged.length / difference.length;
        console.log(
          `${what}, ${integrator}, ${output}: off ${(100 * off).toFixed(2)} %, left out ${(100 * left).toFixed(2)} %`,
        );
        expect(off, 'share of pixels off by more than 1e-3').to.be.below(0.005);
        expect(left, 'share of pixels left out').to.be.below(0.03);
      });
    }
  }

  it('scenes without them have no sampler in their shader', () => {
    const device = new RenderDevice();
    for (const [map, texture] of [
      ['a', true],
      [undefined, false],
    ] as const) {
      const scene = resolveScene(
        parseScene({ objects: [{ type: 'sphere', ...(map && { map }) }] }),
        1,
        undefined,
        images,
      );
      const { fragment } = generateShader(requirements(scene, { bounces: 3, integrator: 'path' }));
      expect(/sampler2D|texelFetch|mapX/.test(fragment)).to.equal(texture);
    }
    device.dispose();
  });
});

/** Four pixels as a file: red, green; blue, grey. */
async function file(type: string): Promise<string> {
  const canvas = Object.assign(document.createElement('canvas'), { width: 2, height: 2 });
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  const bytes = [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 188, 188, 188, 255];
  context.putImageData(new ImageData(new Uint8ClampedArray(bytes), 2, 2), 0, 0);
  return URL.createObjectURL(await new Promise<Blob>((done) => canvas.toBlob((blob) => done(blob as Blob), type)));
}

describe('images on surfaces of <ray-scene>', () => {
  it('are decoded as sRGB, and lie with their first row on top', async () => {
    const address = await file('image/png');
    const element = await sceneWith(
      `<ray-camera type="orthographic" height="4" position="0 0 5"></ray-camera>
       <ray-quad corner="-3 -2 0" edge-u="6 0 0" edge-v="0 4 0" map="${address}"></ray-quad>`,
      'output="albedo" samples="1"',
    );
    await element.complete;
    const radiance = element.readRadiance();
    const at = (x: number, y: number): readonly number[] => [
      ...radiance.subarray(4 * (60 * y + x), 4 * (60 * y + x) + 3),
    ];
    const grey = ((188 / 255 + 0.055) / 1.055) ** 2.4;
    // Beyond the centres of the outer texels colours go on as they are.
    const corners = [at(2, 2), at(57, 2), at(2, 37), at(57, 37)];
    const expected = [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [grey, grey, grey],
    ];
    for (const [i, corner] of corners.entries()) {
      for (const c of [0, 1, 2]) expect(corner[c]).to.be.closeTo(expected[i]?.[c] as number, 1e-6);
    }
  });

  it('tell what is wrong with them, and where', async () => {
    const quiet = new QuietConsole();
    const text = URL.createObjectURL(new Blob(['no image']));
    const element = await sceneWith(
      `<ray-material name="a" map="${text}"></ray-material><ray-group><ray-sphere></ray-sphere><ray-sphere map="no-such.png"></ray-sphere></ray-group>`,
    );
    const { message } = await rejection(element.ready);
    const missing = new URL('no-such.png', document.baseURI).href;
    expect(message.split('\n')).to.deep.equal([
      `ray-scene > ray-material: map must be the address of an image, not "${text}": ${text} could not be loaded: it is no image that this browser reads`,
      `ray-scene > ray-group > ray-sphere[2]: map must be the address of an image, not "no-such.png": ${missing} could not be loaded: 404 Not Found`,
    ]);
    quiet.restore();
  });
});
