/** Scenes with one feature each, for the table of what each adds to the shader, and for the bench of what it costs. */
import type { EnvironmentImages, RenderSettings } from '@ray-scene/core';
import { sky } from './unit/emitter-cases.ts';

/** What scenes of the table ask for. */
export const images: EnvironmentImages = new Map([['an image', sky(4, 2)]]);

const camera = { position: [0, 1, 5], target: [0, 0, 0] };
const ball = { type: 'sphere', specular: 0 };
const lamp = { type: 'point', position: [3, 4, 5], intensity: 100 };
const lamps = [lamp, { ...lamp, position: [-3, 4, 5] }];
const plain = { camera, lights: [lamp], objects: [ball] };
const withBall = (more: object): object => ({ ...plain, objects: [{ ...ball, ...more }] });
const withObject = (object: object): object => ({ ...plain, objects: [ball, object] });

export type Settings = Partial<Pick<RenderSettings, 'bounces' | 'integrator' | 'output' | 'clamp'>>;

export interface FeatureScene {
  /** JSON. */
  readonly scene: object;
  readonly settings?: Settings;
  /** Words that the shader holds because of this, in all rows that name them, and in no other. */
  readonly holds: readonly string[];
}

const FACETS = ['splitAt'];
const ROUGH = ['visibleNormal'];
const MIS = ['powerHeuristic', 'scatteredPdf', 'emitterPdf'];
const THROUGH = ['exactFresnel'];
const MEDIA = ['startMedia', 'refraction'];

/** Each with one ball that is dull and one lamp that is a point, but for what it says; the first one without anything else. */
export const featureScenes: { readonly [what: string]: FeatureScene } = {
  'a dull ball and a lamp': { scene: plain, holds: [] },
  'no light': { scene: { ...plain, lights: [], environment: { color: 'black' } }, holds: ['environmentRadiance'] },
  'a glossy ball': { scene: withBall({ specular: 1 }), holds: [...FACETS, ...ROUGH] },
  'a polished ball': { scene: withBall({ specular: 1, roughness: 0 }), holds: FACETS },
  'a weaker reflection': { scene: withBall({ specular: 0.5 }), holds: [...FACETS, ...ROUGH, 'f90'] },
  'a narrow lobe, and a lamp without size': {
    scene: withBall({ specular: 1, roughness: 0.1 }),
    holds: [...FACETS, ...ROUGH, 'glintLobe'],
  },
  'a narrow lobe, and two lamps without size': {
    scene: { ...withBall({ specular: 1, roughness: 0.1 }), lights: lamps },
    holds: [...FACETS, ...ROUGH, 'glintLobe', 'GlintLobe second', 'chosenEmitter'],
  },
  'a narrow lobe, and no lamp without size': {
    scene: {
      ...withBall({ specular: 1, roughness: 0.1 }),
      lights: [],
      environment: { color: 'white' },
      background: 'black',
    },
    holds: [...FACETS, ...ROUGH, 'environmentRadiance'],
  },
  'a narrow lobe, and paths that end there': {
    scene: withBall({ specular: 1, roughness: 0.1 }),
    settings: { bounces: 1 },
    holds: [...FACETS, ...ROUGH],
  },
  'a metal': { scene: withBall({ metalness: 1 }), holds: [...FACETS, ...ROUGH] },
  'clear glass': {
    scene: withBall({ specular: 1, transmission: 1, roughness: 0 }),
    holds: [...FACETS, ...THROUGH, ...MEDIA],
  },
  'rough glass': {
    scene: withBall({ specular: 1, transmission: 1 }),
    holds: [...FACETS, ...ROUGH, ...THROUGH, ...MEDIA],
  },
  'coloured glass': {
    scene: withBall({ specular: 1, transmission: 1, roughness: 0, attenuationDistance: 1, attenuationColor: 'red' }),
    holds: [...FACETS, ...THROUGH, ...MEDIA, 'transmittance'],
  },
  'a window pane': {
    scene: {
      ...plain,
      objects: [
        { ...ball, specular: 1, roughness: 0 },
        { type: 'quad', transmission: 1, roughness: 0, specular: 1 },
      ],
    },
    holds: [...FACETS, ...THROUGH, 'quadDistance'],
  },
  'a checkered ball': { scene: withBall({ checker: 'red' }), holds: ['sphereCells', 'checkerOdd', 'arcTangent'] },
  'an image on the ball': {
    scene: withBall({ map: 'an image' }),
    holds: ['spherePlace', 'imageTexels', 'sampler2D', 'arcTangent'],
  },
  'two lamps': { scene: { ...plain, lights: lamps }, holds: ['chosenEmitter'] },
  'a spotlight': { scene: { ...plain, lights: [{ ...lamp, type: 'spot' }] }, holds: ['spotSample', 'arcTangent'] },
  'a sun without size': { scene: { ...plain, lights: [{ type: 'directional' }] }, holds: ['directionalSample'] },
  'a soft sun': {
    scene: { ...plain, lights: [{ type: 'directional', angularDiameter: 5 }] },
    holds: [...MIS, 'sunSample', 'sunsAt'],
  },
  'a soft lamp': {
    scene: { ...plain, lights: [{ ...lamp, radius: 0.5 }] },
    holds: [...MIS, 'sphereSample', 'shinesInFront'],
  },
  'a quad that shines': {
    scene: { ...withObject({ type: 'quad', specular: 0, emission: [1, 1, 1] }), lights: [] },
    holds: [...MIS, 'quadSample', 'quadDistance', 'shinesInFront', 'arcTangent'],
  },
  'a turned box that shines': {
    scene: {
      ...withObject({
        type: 'group',
        rotation: [10, 20, 30],
        objects: [{ type: 'box', specular: 0, emission: [1, 1, 1] }],
      }),
      lights: [],
    },
    holds: [...MIS, 'boxSample', 'boxDistance', 'placedDirection', 'shinesInFront', 'toOwnSpace'],
  },
  'a plane that shines, met by chance': {
    scene: { ...withObject({ type: 'plane', specular: 0, point: [0, 3, 0], emission: [1, 1, 1] }) },
    holds: ['planeDistance', 'shinesInFront'],
  },
  'constant surroundings': {
    scene: { ...plain, environment: { color: 'white' }, background: 'black' },
    holds: ['environmentRadiance'],
  },
  'a gradient': {
    scene: { ...plain, environment: { top: 'white', bottom: 'red' }, background: 'black' },
    holds: ['environmentRadiance', 'vec3 slope'],
  },
  'surroundings that are an image': {
    scene: { ...plain, lights: [], environment: { src: 'an image' } },
    holds: [...MIS, 'environmentTexels', 'imageAt', 'sampler2D', 'arcTangent'],
  },
  'a lens': { scene: { ...plain, camera: { ...camera, aperture: 0.1 } }, holds: ['eye.lensX'] },
  'parallel rays of the camera': { scene: { ...plain, camera: { ...camera, type: 'orthographic' } }, holds: [] },
  'more events than roulette waits for': { scene: plain, settings: { bounces: 8 }, holds: ['ROULETTE_FROM'] },
  'a clamp': { scene: plain, settings: { clamp: 10 }, holds: ['mostRadiance'] },
  'another ball in a stretched group': {
    scene: withObject({ type: 'group', scale: [1, 2, 1], objects: [ball] }),
    holds: ['placedDirection'],
  },
  ...Object.fromEntries(
    ['disc', 'box', 'cylinder', 'cone', 'torus', 'triangle'].map((type) => [
      `a ${type} beside it`,
      { scene: withObject({ type, specular: 0 }), holds: [`${type}Distance`] },
    ]),
  ),
};
