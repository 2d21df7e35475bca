/** Takes groups apart: objects and lights where the groups around them put them. */
import { Affine } from './affine.ts';
import type { FlatObject, FlatScene } from './flat-scene.ts';
import { mapShape } from './map-shape.ts';
import type { Light, Scene, SceneObject } from './schema.ts';
import type { Vec3 } from './vector.ts';

export function flattenGroups(scene: Scene): FlatScene {
  const objects: FlatObject[] = [];
  const lights: Light[] = [...scene.lights];
  const visit = (nodes: Scene['objects'], above: readonly number[], map: Affine | undefined): void =>
    nodes.forEach((node, i) => {
      const path = [...above, i];
      if (node.type !== 'group') objects.push({ ...placed(node, map, isPatterned(scene, node)), object: node, path });
      else {
        const inside = (map ?? Affine.identity).within(node);
        lights.push(...node.lights.map((light) => mapLight(light, inside)));
        visit(node.objects, path, inside);
      }
    });
  visit(scene.objects, [], undefined);
  return { objects, lights };
}

/** Whether the places on an object's surface differ. */
function isPatterned({ materials }: Scene, { material = '', checker }: SceneObject): boolean {
  return !!(checker ?? (Object.hasOwn(materials, material) && materials[material]?.checker));
}

/** A shape that is still of its kind is one that says itself where it is; with others goes the map. */
function placed(object: SceneObject, map: Affine | undefined, patterned: boolean): Pick<FlatObject, 'shape' | 'cells'> {
  if (!map) return { shape: object };
  const shape = mapShape(object, map, patterned);
  return shape ? { shape, cells: map.factor } : { shape: { ...object, place: map } };
}

/**
 * Where a light is, where it shines and how large it is, in the scene. What groups scale is lengths: the intensity stays.
 * What a light leaves out means something in the space of its group.
 */
function mapLight(light: Light, map: Affine): Light {
  if (light.type === 'point') return { ...light, ...mapBall(light, map) };
  const { target = ORIGIN, direction } = light;
  if (light.type === 'spot') return { ...light, ...mapBall(light, map), ...mapAim(target, direction, map) };
  const { position } = light;
  if (position) return { ...light, position: map.point(position), ...mapAim(target, direction, map) };
  return { ...light, direction: map.direction(direction ?? DOWN) };
}

/** A ball that shines stays one: where it would not, it is as large as what would become of it. */
const mapBall = ({ position, radius }: { readonly position: Vec3; readonly radius: number }, map: Affine) => ({
  position: map.point(position),
  radius: radius * map.meanFactor,
});

const mapAim = (target: Vec3, direction: Vec3 | undefined, map: Affine) =>
  direction ? { direction: map.direction(direction) } : { target: map.point(target) };

const ORIGIN = [0, 0, 0] as const;
const DOWN = [0, -1, 0] as const;
