// The integrator `path` on the GPU against its f64 twin, path by path: both use the same random numbers.
import { expect } from '@open-wc/testing';
import { parseScene, type Scene } from '@ray-scene/core';
import { agreement } from './agreement.ts';

const SIZE = 64;

function agree(what: string, scene: Scene, integrator: 'path' | 'direct', clamp?: number): void {
  const settings = { width: SIZE, height: SIZE, samples: 1, bounces: 4, integrator, ...(clamp && { clamp }) };
  const { median, off, excluded } = agreement(scene, settings);
  const percent = (share: number): string => `${(100 * share).toFixed(3)} %`;
  console.log(`${what}: median ${median.toExponential(1)}, off ${percent(off)}, excluded ${percent(excluded)}`);
  expect(median, 'median').to.be.below(1e-5);
  expect(off, 'share of pixels off by more than 1e-3').to.be.below(5e-3);
  expect(excluded, 'share of ill-conditioned pixels').to.be.below(0.03);
}

describe('paths on the GPU against the reference', function () {
  this.timeout(120_000);

  const ball = { type: 'sphere', center: [0, 0, 0], radius: 1 };
  const floor = { type: 'plane', point: [0, -1, 0], checker: 'black' };
  const lamp = { type: 'point', position: [2, 3, 4], intensity: 60 };
  const camera = { position: [0.5, 1, 5] };
  const sky = { top: 'skyblue', bottom: 'white' };
  const panel = { type: 'quad', corner: [-1, 2.5, -1], edgeU: [2, 0, 0], edgeV: [0, 0, 2], emission: [8, 7, 6] };

  const scenes: { readonly [what: string]: object } = {
    'a dull ball under the sky': { camera, environment: sky, objects: [{ ...ball, specular: 0 }] },
    'a glossy ball under the sky': { camera, environment: sky, objects: [ball, floor] },
    'a lamp': { camera, lights: [lamp], objects: [{ ...ball, specular: 0 }, floor] },
    'a soft lamp, a spotlight and a sun': {
      camera,
      lights: [
        { ...lamp, radius: 0.5 },
        { type: 'spot', position: [-3, 4, 2], intensity: 90, angle: 20, penumbra: 0.3 },
        { type: 'directional', direction: [-1, -2, -1], intensity: 2, angularDiameter: 5 },
      ],
      objects: [ball, floor],
    },
    'a panel of light': { camera, objects: [ball, floor, panel] },
    'metals, rough and smooth': {
      camera,
      environment: sky,
      lights: [lamp],
      objects: [
        { ...ball, metalness: 1, roughness: 0.4, color: 'gold' },
        { ...ball, center: [2, 0, -1], material: 'mirror' },
        floor,
      ],
    },
    'a glass ball': { camera, environment: sky, objects: [{ ...ball, material: 'glass' }, floor] },
    'frosted, coloured and nested glass': {
      camera,
      environment: sky,
      lights: [lamp],
      objects: [
        { ...ball, material: 'glass' },
        { ...ball, radius: 0.5, material: 'water', attenuationColor: 'red', attenuationDistance: 0.5 },
        { ...ball, center: [2, 0, -1], material: 'glass', roughness: 0.4 },
        { type: 'quad', corner: [-2, -1, 1], edgeU: [1, 0, 0], edgeV: [0, 2, 0], material: 'glass', color: 'green' },
        floor,
      ],
    },
    'everything that can shine': {
      camera,
      objects: [
        floor,
        { type: 'disc', center: [-2, 2, 0], normal: [1, -1, 0], radius: 0.5, emission: [9, 5, 5] },
        { type: 'triangle', a: [1, 3, 0], b: [2, 3, 1], c: [2, 3, 0], emission: [5, 9, 5], emissionSide: 'both' },
        { type: 'box', center: [2, 0, 0], size: [0.5, 0.5, 0.5], emission: [5, 5, 9] },
        { type: 'cylinder', base: [-2, -1, 0], top: [-2, 1, -1], radius: 0.2, emission: [3, 3, 3] },
        { type: 'torus', radius: 0.7, tube: 0.2, axis: [0, 1, 1], emission: [1, 1, 0] },
        ball,
      ],
    },
    'the glint of a lamp': { camera, lights: [lamp], objects: [{ ...ball, roughness: 0.1, metalness: 1 }, floor] },
    'glints of several lamps on several balls, beside a panel': {
      camera,
      lights: [
        lamp,
        { type: 'spot', position: [-3, 4, 2], intensity: 90, angle: 30, penumbra: 0.3 },
        { type: 'directional', direction: [-1, -2, -1], intensity: 2 },
      ],
      objects: [
        { ...ball, roughness: 0.1 },
        { ...ball, center: [2, -0.5, -1], radius: 0.5, roughness: 0.1, metalness: 1 },
        { ...ball, center: [-2, 0, -1], material: 'glass', roughness: 0.3 },
        floor,
        panel,
      ],
    },
    'the glint of a ball seen on glass and metal': {
      camera,
      lights: [lamp],
      objects: [
        { ...ball, roughness: 0.05, metalness: 1 },
        { ...ball, center: [2, 0, -1], material: 'mirror' },
        { ...ball, center: [-2, 0, -1], material: 'glass', roughness: 0.6 },
        { type: 'quad', corner: [-2, -1, 1], edgeU: [1, 0, 0], edgeV: [0, 2, 0], transmission: 1, roughness: 0.5 },
        floor,
      ],
    },
    'shapes that shine in spaces of their own, from outside and inside': {
      camera,
      objects: [
        floor,
        {
          type: 'group',
          rotation: [20, 40, 10],
          scale: [1, 0.6, 1.5],
          objects: [
            { type: 'sphere', center: [-2, 2, 0], radius: 0.4, emission: [9, 5, 5] },
            { type: 'box', center: [2, 1, 0], size: [0.5, 0.8, 0.5], emission: [5, 5, 9], emissionSide: 'both' },
            { type: 'cylinder', base: [0, 3, 0], top: [1, 3, -1], radius: 0.2, emission: [3, 9, 3] },
            { type: 'sphere', center: [0, 0, 0], radius: 9, emission: [0.2, 0.2, 0.3], emissionSide: 'back' },
          ],
        },
        ball,
      ],
    },
    'nothing at all': { environment: sky, background: 'teal' },
    'a thin lens': { camera: { ...camera, aperture: 0.2 }, environment: sky, objects: [ball, floor] },
    'an orthographic view': { camera: { ...camera, type: 'orthographic' }, environment: sky, objects: [ball, floor] },
  };

  for (const [what, scene] of Object.entries(scenes)) {
    it(`draws ${what} alike`, () => agree(what, parseScene(scene), 'path'));
  }

  it('dims what is brighter than the clamp alike', () =>
    agree('clamp', parseScene(scenes['everything that can shine']), 'path', 0.3));

  const examples = [
    'ball-lens',
    'classic',
    'cornell',
    'focus',
    'metals',
    'planet',
    'rough-glass',
    'shadows',
    'whitted',
  ];
  for (const name of examples) {
    it(`draws the example ${name} alike`, async () =>
      agree(name, parseScene(await (await fetch(`/examples/scenes/${name}.json`)).text()), 'path'));
  }

  const whitted = [
    'a soft lamp, a spotlight and a sun',
    'a glass ball',
    'frosted, coloured and nested glass',
    'everything that can shine',
  ];
  for (const what of whitted) {
    it(`draws ${what} alike by the integrator direct`, () =>
      agree(`direct: ${what}`, parseScene(scenes[what]), 'direct'));
  }
});
