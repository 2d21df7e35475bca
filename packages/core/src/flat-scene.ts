/** A scene without its groups: every object and light where it is. */
import type { Affine } from './affine.ts';
import { moreParts } from './parts.ts';
import type { ShapeKind } from './primitives/index.ts';
import type { Light, Scene, SceneObject, Shape } from './schema.ts';

/** A shape, and where it stays in a space of its own the map from there to the scene. */
export type PlacedShape = Shape<ShapeKind> & { readonly place?: Affine };

export interface FlatObject {
  readonly shape: PlacedShape;
  /** As the author has it. */
  readonly object: SceneObject;
  /** Where the author has it: `[2, 0]` is `objects[2].objects[0]`. */
  readonly path: readonly number[];
  /** How many times as large as its material says the cells of a checker are: the groups scale them with the shape. */
  readonly cells?: number;
}

export interface FlatScene {
  readonly objects: readonly FlatObject[];
  readonly lights: readonly Light[];
}

export function flatScene(scene: Scene): FlatScene {
  const objects = scene.objects.map((object, i) => ({ shape: object, object, path: [i] }));
  return objects.some(({ object }) => object.type === 'group')
    ? moreParts().flattenGroups(scene)
    : { objects: objects as readonly FlatObject[], lights: scene.lights };
}
