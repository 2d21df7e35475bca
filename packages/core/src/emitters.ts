/** What can be asked for light: point-like lights, suns and objects that shine, in f64 and scene coordinates. */
import type { Affine } from './affine.ts';
import { emitterPower, litBall } from './emitter-power.ts';
import { type EnvironmentImage, type ImageTable, imageTable } from './environment-image.ts';
import type { PlacedShape } from './flat-scene.ts';
import { directionToLight } from './light-records.ts';
import type { Shape } from './schema.ts';
import { dot, normalize, scale, subtract, type Vec3 } from './vector.ts';

/** How a spotlight fades with the angle from its axis: 1 up to outer (1 - penumbra), then linearly to 0 at `outer`. */
export interface Profile {
  /** Unit vector in which it shines. */
  readonly axis: Vec3;
  /** In radians. */
  readonly outer: number;
  /** From 0 to 1. */
  readonly penumbra: number;
}

interface PointSource {
  readonly position: Vec3;
  /** Candela. */
  readonly intensity: Vec3;
  /** By which power of the distance it fades. */
  readonly decay: 0 | 2;
}

/** What all objects that shine have in common. */
interface Shining {
  readonly radiance: Vec3;
  /** `front` is the side that the outward normal points to. */
  readonly side: 'front' | 'back' | 'both';
  /** Index into `ResolvedScene.objects`. */
  readonly object: number;
  /** From the space that the rest of it is in to the scene, where that is not the scene itself. */
  readonly place?: Affine;
}

interface EmitterKinds {
  point: PointSource;
  spot: PointSource & { readonly profile: Profile };
  /** `toLight` is a unit vector. */
  directional: { readonly toLight: Vec3; readonly irradiance: Vec3 };
  /** Radiance from all directions whose angle with `toLight` has a cosine of at least 1 - cone. */
  sun: { readonly toLight: Vec3; readonly radiance: Vec3; readonly cone: number };
  /** With a profile, the radiance depends on the direction in which it leaves. */
  sphere: Shining & Pick<Shape<'sphere'>, 'center' | 'radius'> & { readonly profile?: Profile };
  /** Places on it are drawn by solid angle where that is at least `leastAngle`, else by area. */
  quad: Shining & Pick<Shape<'quad'>, 'corner' | 'edgeU' | 'edgeV'> & { readonly leastAngle: number };
  disc: Shining & Pick<Shape<'disc'>, 'center' | 'normal' | 'radius'>;
  triangle: Shining & Pick<Shape<'triangle'>, 'a' | 'b' | 'c'>;
  box: Shining & Pick<Shape<'box'>, 'center' | 'size'>;
  cylinder: Shining & Pick<Shape<'cylinder'>, 'base' | 'top' | 'radius'>;
  /** The surroundings: an image times the intensity, turned about +y, counterclockwise from above, by `turn` of a full turn. */
  image: { readonly image: ImageTable; readonly intensity: number; readonly turn: number };
}

export type EmitterKind = keyof EmitterKinds;
/** In the order of the numbers that shaders know them by. */
export const emitterKinds = [
  'point',
  'spot',
  'directional',
  'sun',
  'sphere',
  'quad',
  'disc',
  'triangle',
  'box',
  'cylinder',
  'image',
] as const satisfies readonly EmitterKind[];

export type BareEmitter = { [K in EmitterKind]: { readonly kind: K } & EmitterKinds[K] }[EmitterKind];
export type EmitterOf<K extends EmitterKind> = Extract<Emitter, { kind: K }>;
/** `power`: how much of its light falls on the scene, roughly (the mean of the channels); it is chosen accordingly. */
export type Emitter = BareEmitter & { readonly power: number };

interface LocalLight {
  readonly position: Vec3;
  readonly color: Vec3;
  readonly intensity: number;
  readonly decay: 0 | 2;
  /** Above 0, it is a ball, and stands among the objects. */
  readonly radius?: number;
}

interface SpotLight extends LocalLight {
  readonly type: 'spot';
  readonly target?: Vec3;
  readonly direction?: Vec3;
  /** In degrees. */
  readonly angle: number;
  readonly penumbra: number;
}

type DirectionalLight = Parameters<typeof directionToLight>[0] & { readonly angularDiameter?: number };
type EmittingLight = (LocalLight & { readonly type: 'point' }) | SpotLight | DirectionalLight;

/** What a scene must tell for its emitters to be known. */
export interface EmittingScene {
  readonly camera: { readonly position: Vec3; readonly target: Vec3 };
  readonly lights: readonly EmittingLight[];
  readonly materials: readonly {
    readonly emission: Vec3;
    readonly emissionIntensity: number;
    readonly emissionSide: Shining['side'];
  }[];
  readonly objects: readonly {
    readonly shape: PlacedShape;
    readonly material: number;
    /** Index of the light that the object is the ball of. */
    readonly light?: number;
  }[];
  readonly environment?: ImageEnvironment | { readonly kind: 'constant' | 'gradient' };
}

/** Surroundings that are an image. */
export interface ImageEnvironment {
  readonly kind: 'image';
  readonly image: EnvironmentImage;
  readonly intensity: number;
  /** In degrees about +y, counterclockwise from above. */
  readonly rotation: number;
}

/**
 * The emitters of a scene: lights in their order (but for those that are balls), then objects, then surroundings that are
 * an image. Other surroundings, and planes, cones and tori that shine, are not among them: paths meet those by chance.
 */
export function sceneEmitters(scene: EmittingScene): readonly Emitter[] {
  const points = scene.lights.filter((light) => light.type === 'directional' || !light.radius).map(lightEmitter);
  const shining = scene.objects.flatMap((_, object) => objectEmitter(scene, object));
  const ball = litBall(scene);
  return [...points, ...shining, ...surroundings(scene)].map((emitter) => ({
    ...emitter,
    power: emitterPower(emitter, ball),
  }));
}

const lightEmitter = (light: EmittingLight): BareEmitter =>
  light.type === 'directional' ? distantEmitter(light) : pointEmitter(light);

function pointEmitter(light: Exclude<EmittingLight, DirectionalLight>): BareEmitter {
  const { position, decay } = light;
  const source = { position, decay, intensity: scale(light.color, light.intensity) };
  return light.type === 'point' ? { kind: 'point', ...source } : { kind: 'spot', ...source, profile: profileOf(light) };
}

function profileOf({ position, target = [0, 0, 0], direction, angle, penumbra }: SpotLight): Profile {
  return { axis: normalize(direction ?? subtract(target, position)), outer: (angle * Math.PI) / 180, penumbra };
}

/** A sun of a smaller radius, in radians, is a point: unit vectors in f32 are no nearer to one another. */
const SMALLEST_SUN = 2 ** -24;

function distantEmitter(light: DirectionalLight): BareEmitter {
  const toLight = directionToLight(light);
  const irradiance = scale(light.color, light.intensity);
  const half = ((light.angularDiameter ?? 0) * Math.PI) / 360;
  if (half < SMALLEST_SUN) return { kind: 'directional', toLight, irradiance };
  // A surface that faces it receives π sin² times its radiance.
  const radiance = scale(irradiance, 1 / (Math.PI * Math.sin(half) ** 2));
  return { kind: 'sun', toLight, radiance, cone: 2 * Math.sin(half / 2) ** 2 };
}

const surroundings = ({ environment }: EmittingScene): readonly BareEmitter[] =>
  environment?.kind === 'image'
    ? [
        {
          kind: 'image',
          image: imageTable(environment.image),
          intensity: environment.intensity,
          turn: environment.rotation / 360,
        },
      ]
    : [];

/** The emitter that an object is, if it is one. */
function objectEmitter({ lights, materials, objects }: EmittingScene, object: number): readonly BareEmitter[] {
  const { shape, material: index, light = -1 } = objects[object] as EmittingScene['objects'][number];
  const { emission, emissionIntensity, emissionSide: side } = materials[index] as EmittingScene['materials'][number];
  const radiance = scale(emission, emissionIntensity);
  if (Math.max(...radiance) === 0) return [];
  const shining = { radiance, side, object, ...(shape.place ? { place: shape.place } : {}) };
  const source = lights[light];
  switch (shape.type) {
    case 'sphere': {
      const { center, radius } = shape as Shape<'sphere'>;
      const profile = source?.type === 'spot' ? { profile: profileOf(source) } : {};
      return [{ kind: 'sphere', center, radius, ...shining, ...profile }];
    }
    case 'quad': {
      const { corner, edgeU, edgeV } = shape as Shape<'quad'>;
      return [{ kind: 'quad', corner, edgeU, edgeV, leastAngle: leastAngle(edgeU, edgeV), ...shining }];
    }
    case 'disc': {
      const { center, normal, radius } = shape as Shape<'disc'>;
      return [{ kind: 'disc', center, normal, radius, ...shining }];
    }
    case 'triangle': {
      const { a, b, c } = shape as Shape<'triangle'>;
      return [{ kind: 'triangle', a, b, c, ...shining }];
    }
    case 'box': {
      const { center, size } = shape as Shape<'box'>;
      return [{ kind: 'box', center, size, ...shining }];
    }
    case 'cylinder': {
      const { base, top, radius } = shape as Shape<'cylinder'>;
      return [{ kind: 'cylinder', base, top, radius, ...shining }];
    }
    default:
      return [];
  }
}

/** Below this solid angle f32 does not draw places on a rectangle well, and they are nearly alike anyway. */
const LEAST_ANGLE = 1 / 64;

/** How far from a right angle the edges of a rectangle may be that was turned in f64. */
const ROUNDED = 2 ** -40;

const leastAngle = (edgeU: Vec3, edgeV: Vec3): number =>
  Math.abs(dot(normalize(edgeU), normalize(edgeV))) < ROUNDED ? LEAST_ANGLE : Number.POSITIVE_INFINITY;
