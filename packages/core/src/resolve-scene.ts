/** What an author left out gets an answer that looks good, and names become indices: the scene that is rendered. */
import type { ResolvedCamera } from './camera-frame.ts';
import type { ImageEnvironment } from './emitters.ts';
import type { EnvironmentImage } from './environment-image.ts';
import { type FlatObject, flatScene, type PlacedShape } from './flat-scene.ts';
import { frameObjects } from './frame-objects.ts';
import { knownMaterials } from './named-materials.ts';
import { primitiveOf } from './parts.ts';
import { primitives, shapeKinds } from './primitives/index.ts';
import { type Background, type Light, type Material, material, type Scene, type SceneObject } from './schema.ts';
import { scale, type Vec3 } from './vector.ts';

/** Radiance from all around: top where y = 1, bottom where y = -1, linear in y between; `constant` when equal by design. */
export interface EvenEnvironment {
  readonly kind: 'constant' | 'gradient';
  readonly top: Vec3;
  readonly bottom: Vec3;
}

export type ResolvedEnvironment = EvenEnvironment | ImageEnvironment;

/** Images that have been loaded, by the address that the scene gives. */
export type EnvironmentImages = ReadonlyMap<string, EnvironmentImage>;

export interface ResolvedObject extends Pick<FlatObject, 'shape' | 'path'> {
  /** Index into `materials`. */
  readonly material: number;
  /** Index into `lights` of the light that it is the ball of: then it has no path. */
  readonly light?: number;
}

export interface ResolvedScene {
  readonly camera: ResolvedCamera;
  readonly environment?: ResolvedEnvironment;
  readonly background: Background;
  /** Those that were handed in. */
  readonly images?: EnvironmentImages | undefined;
  /** Those of the author, or of the studio. */
  readonly lights: readonly Light[];
  readonly materials: readonly Material[];
  /** Objects that the camera is inside of, the innermost first, where light passes through them. */
  readonly around: readonly number[];
  /** Ordered by kind as in `shapeKinds`, those that stay in a space of their own after the others. */
  readonly objects: readonly ResolvedObject[];
}

/** The neutral studio that lights a scene without light of its own: a soft sky and one key light from the upper left. */
const studio = {
  environment: { kind: 'gradient', top: [0.55, 0.55, 0.55], bottom: [0.1, 0.1, 0.1] } satisfies ResolvedEnvironment,
  key: {
    type: 'directional',
    direction: [1, -2, -1],
    color: [1, 1, 1],
    intensity: 1.5,
    angularDiameter: 0,
  } satisfies Light,
} as const;

/**
 * Resolves a scene for a picture whose width is `aspect` times its height. `camera` replaces the scene's own, as
 * camera controls do. Surroundings whose image is not among `images` are dark, and a `map` that is not changes nothing.
 */
export function resolveScene(
  scene: Scene,
  aspect = 1,
  camera?: ResolvedCamera,
  images?: EnvironmentImages,
): ResolvedScene {
  const materials = new MaterialTable(scene);
  const flat = flatScene(scene);
  const given = withoutTwins(flat.objects).map(({ shape, object, path, cells }) => ({
    shape,
    material: materials.indexOf(object, cells),
    path,
  }));
  const unlit = flat.lights.length === 0 && !scene.environment && !materials.list.some(isEmissive);
  const lights = unlit ? [studio.key] : flat.lights;
  const objects = [...given, ...ballsOf(lights, materials)].sort((a, b) => orderOf(a.shape) - orderOf(b.shape));
  const environment = unlit ? studio.environment : environmentOf(scene, images);
  const view = camera ?? frameObjects(scene, aspect);
  return {
    camera: view,
    ...(environment ? { environment } : {}),
    images,
    background: scene.background ?? (scene.environment ? 'environment' : 'transparent'),
    lights,
    materials: materials.list,
    around: objectsAround(view, objects, materials.list),
    objects,
  };
}

/** Of shapes that are the same to the last digit, the first: from either side, it is in front of the others. */
function withoutTwins(objects: readonly FlatObject[]): readonly FlatObject[] {
  const known = new Set<string>();
  return objects.filter(({ shape }) => {
    const { type, place } = shape;
    const own = Object.keys(primitives[type].fields).map((name) => shape[name as keyof PlacedShape]);
    const key = JSON.stringify([type, place?.columns, place?.offset, own]);
    return !known.has(key) && known.add(key);
  });
}

const orderOf = ({ type, place }: PlacedShape): number => 2 * shapeKinds.indexOf(type) + (place ? 1 : 0);

/** Whether the material shines by itself. */
export const isEmissive = ({ emission, emissionIntensity }: Material): boolean =>
  emissionIntensity > 0 && emission.some((channel) => channel > 0);

/** The visible balls of lights that have a radius: each sends out as much as the point would, and reflects nothing. */
function ballsOf(lights: readonly Light[], materials: MaterialTable): ResolvedObject[] {
  return lights.flatMap((node, light) => {
    if (node.type === 'directional' || !node.radius) return [];
    const { position: center, radius, color, intensity } = node;
    const emission = scale(color, intensity / (Math.PI * radius * radius));
    const material = materials.add({ ...materialDefaults, color: BLACK, specular: 0, emission });
    return [{ shape: { type: 'sphere', center, radius } as const, material, path: [], light }];
  });
}

const BLACK: Vec3 = [0, 0, 0];

/** The closed objects that a camera is inside of, by their numbers, from the smallest to the largest. */
function objectsAround(
  { position }: ResolvedCamera,
  objects: readonly ResolvedObject[],
  materials: readonly Material[],
): readonly number[] {
  const inside = objects
    .map((_, number) => number)
    .filter((number) => {
      const { shape, material } = objects[number] as ResolvedObject;
      const transmits = (materials[material] as Material).transmission > 0;
      const primitive = transmits ? primitiveOf(shape) : undefined;
      return !!primitive?.closed && primitive.side(shape, position) < 0;
    });
  const size = (number: number): number => {
    const { shape } = objects[number] as ResolvedObject;
    return primitiveOf(shape).size(shape);
  };
  return inside.sort((a, b) => size(a) - size(b));
}

function environmentOf({ environment }: Scene, images?: EnvironmentImages): ResolvedEnvironment | undefined {
  if (!environment) return undefined;
  const { src, color = [1, 1, 1], top, bottom, intensity, rotation } = environment;
  if (src) {
    const image = images?.get(src);
    return image && { kind: 'image', image, intensity, rotation };
  }
  return {
    kind: top ? 'gradient' : 'constant',
    top: scale(top ?? color, intensity),
    bottom: scale(bottom ?? color, intensity),
  };
}

const materialDefaults = Object.fromEntries(
  Object.entries(material.fields)
    .filter(([, field]) => field.default !== undefined)
    .map(([name, field]) => [name, field.default]),
) as unknown as Material;

/** The materials that are in use, each once. */
class MaterialTable {
  readonly list: Material[] = [];
  readonly #indices = new Map<string, number>();
  readonly #scene: Scene;

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  /** The material of an object whose checker has cells so many times as large. */
  indexOf(object: SceneObject, cells = 1): number {
    const named = object.material === undefined ? {} : this.#named(object.material);
    const own = Object.fromEntries(
      Object.entries(object).filter(([name]) => Object.hasOwn(material.fields, name)),
    ) as Partial<Material>;
    const given = { ...materialDefaults, ...named, ...own };
    const resolved = { ...given, checkerSize: given.checkerSize * cells };
    // Every object that shines is a light of its own, and an image lies on each in its own way.
    if (isEmissive(resolved) || resolved.map) return this.add(resolved);
    const key = JSON.stringify(Object.keys(material.fields).map((name) => resolved[name as keyof Material]));
    const known = this.#indices.get(key) ?? this.add(resolved);
    this.#indices.set(key, known);
    return known;
  }

  /** A material that no other object shares. */
  add(material: Material): number {
    return this.list.push(material) - 1;
  }

  #named(name: string): Partial<Material> {
    const { materials } = this.#scene;
    return (Object.hasOwn(materials, name) ? materials[name] : knownMaterials()[name]) ?? {};
  }
}
