/** What an author left out gets an answer that looks good, and names become indices: the scene that is rendered. */
import { builtInMaterials } from './built-in-materials.ts';
import type { ResolvedCamera } from './camera-frame.ts';
import { frameObjects } from './frame-objects.ts';
import { type ShapeKind, shapeKinds } from './primitives/index.ts';
import { type Background, type Light, type Material, material, type Scene, type Shape } from './schema.ts';
import { scale, type Vec3 } from './vector.ts';

/** Radiance from all around: top where y = 1, bottom where y = -1, linear in y between; `constant` when equal by design. */
export interface ResolvedEnvironment {
  readonly kind: 'constant' | 'gradient';
  readonly top: Vec3;
  readonly bottom: Vec3;
}

export interface ResolvedObject {
  readonly shape: Shape<ShapeKind>;
  /** Index into `materials`. */
  readonly material: number;
  /** Index of the object in the author's list. */
  readonly index: number;
}

export interface ResolvedScene {
  readonly camera: ResolvedCamera;
  readonly environment?: ResolvedEnvironment;
  readonly background: Background;
  readonly lights: readonly Light[];
  readonly materials: readonly Material[];
  /** Ordered by kind as in `shapeKinds`: an object's place here is its number in the shader. */
  readonly objects: readonly ResolvedObject[];
}

/** The neutral studio that lights a scene without light of its own: a soft sky and one key light from the upper left. */
const studio = {
  environment: { kind: 'gradient', top: [1, 1, 1], bottom: [0.25, 0.25, 0.25] } satisfies ResolvedEnvironment,
  key: { type: 'directional', direction: [1, -2, -1.5], color: [1, 1, 1], intensity: 1.6 } satisfies Light,
} as const;

/**
 * Resolves a scene for a picture whose width is `aspect` times its height. `camera` replaces the scene's own, as
 * camera controls do.
 */
export function resolveScene(scene: Scene, aspect = 1, camera?: ResolvedCamera): ResolvedScene {
  const materials = new MaterialTable(scene);
  const objects = scene.objects
    .map((object, index) => ({ shape: object, material: materials.indexOf(object), index }))
    .sort((a, b) => shapeKinds.indexOf(a.shape.type) - shapeKinds.indexOf(b.shape.type));
  const unlit = scene.lights.length === 0 && !scene.environment;
  const environment = unlit ? studio.environment : environmentOf(scene);
  return {
    camera: camera ?? frameObjects(scene, aspect),
    ...(environment ? { environment } : {}),
    background: scene.background ?? (scene.environment ? 'environment' : 'transparent'),
    lights: unlit ? [studio.key] : scene.lights,
    materials: materials.list,
    objects,
  };
}

function environmentOf({ environment }: Scene): ResolvedEnvironment | undefined {
  if (!environment) return undefined;
  const { color = [1, 1, 1], top, bottom, intensity } = environment;
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

  indexOf(object: Scene['objects'][number]): number {
    const named = object.material === undefined ? {} : this.#named(object.material);
    const own = Object.fromEntries(
      Object.entries(object).filter(([name]) => Object.hasOwn(material.fields, name)),
    ) as Partial<Material>;
    const resolved = { ...materialDefaults, ...named, ...own };
    const key = JSON.stringify(Object.keys(material.fields).map((name) => resolved[name as keyof Material]));
    const known = this.#indices.get(key) ?? this.list.push(resolved) - 1;
    this.#indices.set(key, known);
    return known;
  }

  #named(name: string): Partial<Material> {
    const { materials } = this.#scene;
    return (Object.hasOwn(materials, name) ? materials[name] : builtInMaterials[name]) ?? {};
  }
}
