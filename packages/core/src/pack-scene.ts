/** Scene and requirements to the bytes of the two uniform blocks: `Scene` (also when the camera moves) and `View`. */
import { type CameraFrame, rayDirection } from './camera-frame.ts';
import { type Frame, powerOfTwoBelow, toFrame } from './frame.ts';
import { type DirectKind, directionToLight, directKinds, lightRecords, packLight } from './light-records.ts';
import { materialRecord, packMaterial } from './material-record.ts';
import { moreParts, pathParts, primitiveOf, primitiveOfKind } from './parts.ts';
import { shapeKinds } from './primitives/index.ts';
import { pixelSample } from './random.ts';
import { placedCount, type Requirements } from './requirements.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { frameOrigin } from './scene-needs.ts';
import type { Light, Material } from './schema.ts';
import { type BlockLayout, layoutBlock, layoutStruct, writeStruct } from './std140.ts';
import { length } from './vector.ts';
import { eyeRecord, packEye, packSurroundings, type SampleNumber, surroundingsRecord } from './view-record.ts';

/** The block `Scene` of a shader with these requirements; `gapless`, see `layoutStruct`. */
export function sceneLayout(required: Requirements, { gapless = false } = {}): BlockLayout {
  const has = (feature: string): boolean => required.features.some((one) => one === feature);
  const paths = has('path') ? pathParts() : undefined;
  const material = { name: 'material', type: 'int', when: 'indexed' } as const;
  const struct = (name: string, members: Parameters<typeof layoutStruct>[1]) =>
    layoutStruct(name, members, has, gapless);
  return layoutBlock('Scene', [
    ...shapeKinds
      .filter((kind) => required.shapes[kind] + required.placed[kind] > 0)
      .map((kind) => ({
        name: arrayName(kind),
        struct: struct(structName(kind), [...primitiveOfKind(kind).record, material]),
        count: required.shapes[kind] + required.placed[kind],
      })),
    ...(placedCount(required) > 0
      ? [
          {
            name: 'placements',
            struct: struct('Placement', moreParts().placed.placementRecord),
            count: placedCount(required),
          },
        ]
      : []),
    ...directKinds.map((kind) => ({
      name: arrayName(lightRecords[kind].struct),
      struct: struct(lightRecords[kind].struct, lightRecords[kind].record),
      count: required.lights[kind],
    })),
    ...(paths?.emitterEntries(required.features, required.emitters) ?? []),
    {
      name: 'materials',
      struct: struct('Material', [...materialRecord, ...(paths?.materialRecord ?? [])]),
      count: required.materials,
    },
    { name: 'surroundings', struct: struct('Surroundings', surroundingsRecord) },
  ]);
}

/** The block `View` of a shader in which these names are defined. */
export function viewLayout(defined: ReadonlySet<string>): BlockLayout {
  const record = [...eyeRecord, ...(defined.has('PATH') ? pathParts().eyeRecord : [])];
  return layoutBlock('View', [{ name: 'eye', struct: layoutStruct('Eye', record, (name) => defined.has(name)) }]);
}

/** `Sphere` for the kind sphere. */
export const structName = (kind: string): string => `${kind[0]?.toUpperCase()}${kind.slice(1)}`;
/** `spheres` for the kind sphere or the struct Sphere. */
export const arrayName = (kind: string): string => `${kind[0]?.toLowerCase()}${kind.slice(1)}s`;

/** The space that a scene is packed in: its origin is the camera, its unit a power of two near the largest length. */
export function packingFrame(scene: ResolvedScene): Frame {
  const { objects, lights } = scene;
  const unscaled = { origin: frameOrigin(scene), scale: 1 };
  const lengths = [
    ...objects.map(({ shape }) => primitiveOf(shape).extent(shape, unscaled)),
    ...lights.map((light) => (light.type !== 'directional' ? length(toFrame(unscaled, light.position)) : 0)),
  ];
  const largest = Math.max(...lengths);
  return { origin: unscaled.origin, scale: largest > 0 ? 1 / powerOfTwoBelow(largest) : 1 };
}

/**
 * The bytes of the block `Scene`. Where an earlier scene needed more places, the ones that this scene does not fill hold
 * objects that no ray meets, and lights without light.
 */
export function packScene(scene: ResolvedScene, required: Requirements, block: BlockLayout): ArrayBuffer {
  const frame = packingFrame(scene);
  const writer = new BlockWriter(block);
  const indexed = required.features.includes('indexed');
  const wideRange = required.features.includes('wideRange');
  const numbers = objectNumbers(scene, required);
  const paths = required.features.includes('path') ? pathParts() : undefined;
  const lit = paths?.packEmitters(scene, frame, numbers, required);
  lit?.emitters.forEach(({ record }, i) => {
    writer.write('emitters', i, record);
  });
  if (lit) writer.write('choice', 0, lit.choice);
  lit?.glints.forEach((record, i) => {
    writer.write('glints', i, record);
  });
  const shining = lit?.emitters.map(({ object }) => scene.objects[object ?? -1]?.material) ?? [];
  const material = (index: number) => {
    const one = scene.materials[index] as Material;
    return { ...packMaterial(one), ...paths?.packMaterial(scene, index, frame, shining.indexOf(index)) };
  };
  if (indexed) for (const i of scene.materials.keys()) writer.write('materials', i, material(i));
  let number = 0;
  let placements = 0;
  for (const kind of shapeKinds) {
    const [plain, placed] = [required.shapes[kind], required.placed[kind]];
    const absent = plain + placed > 0 && primitiveOfKind(kind).absent;
    for (let i = 0; absent && i < plain + placed; i++) writer.write(arrayName(kind), i, { ...absent, material: 0 });
    let [i, j] = [0, 0];
    for (const { shape, material: index } of scene.objects.filter((object) => object.shape.type === kind)) {
      const place = shape.place && moreParts().placed.packPlacement(shape, shape.place, frame, wideRange);
      if (place) writer.write('placements', placements + j, place);
      const at = place ? plain + j++ : i++;
      const side = primitiveOf(shape).side(shape, frame.origin);
      const checkerSize = (scene.materials[index] as Material).checkerSize;
      const record = primitiveOf(shape).pack(shape, frame, { side, checkerSize, wideRange });
      writer.write(arrayName(kind), at, { ...record, material: index });
      if (!indexed) writer.write('materials', number + at, material(index));
    }
    number += plain;
    placements += placed;
  }
  for (const kind of directKinds) {
    const ofKind = scene.lights.filter((light): light is DirectLight => light.type === kind);
    ofKind.forEach((light, i) => {
      writer.write(arrayName(lightRecords[kind].struct), i, packLight(dimmed(scene, light), frame));
    });
  }
  const around = scene.around.map((number) => numbers[number] as number);
  writer.write('surroundings', 0, packSurroundings(scene, around));
  return writer.bytes;
}

/** By an object's place in the scene: its number in the shader, where there may be places between that are not filled. */
function objectNumbers({ objects }: ResolvedScene, { shapes, placed }: Requirements): readonly number[] {
  let first = 0;
  return shapeKinds.flatMap((kind) => {
    let [plain, own] = [first, first + shapes[kind]];
    first = own + placed[kind];
    return objects.filter(({ shape }) => shape.type === kind).map(({ shape }) => (shape.place ? own++ : plain++));
  });
}

/** The bytes of the block `View`. */
export function packView(
  view: CameraFrame,
  block: BlockLayout,
  frame: Frame,
  sample: SampleNumber = { sample: 0, seed: 0 },
): ArrayBuffer {
  const writer = new BlockWriter(block);
  const has = (member: string): boolean => !!block.entries[0]?.struct.members.some(({ name }) => name === member);
  // The first parts of vectors by themselves, or with what is left of them.
  const paths = has('sequence');
  const eye = packEye(paths ? view : movedTo(pixelSample(sample.sample, sample.seed), view), has('corner2'));
  writer.write('eye', 0, { ...eye, ...(paths ? pathParts().packEye(view, frame, sample) : {}) });
  return writer.bytes;
}

/** With the centres of pixels where one place of all pixels was: [0, 1)², x to the right, y down. */
const movedTo = ([x, y]: readonly [number, number], view: CameraFrame): CameraFrame => ({
  ...view,
  corner: rayDirection(view, x - 0.5, 0.5 - y),
});

class BlockWriter {
  readonly bytes: ArrayBuffer;
  readonly #view: DataView;
  readonly #block: BlockLayout;

  constructor(block: BlockLayout) {
    this.bytes = new ArrayBuffer(block.size);
    this.#view = new DataView(this.bytes);
    this.#block = block;
  }

  /** Writes the `index`-th struct of an entry, if the shader asks for that entry at all. */
  write(name: string, index: number, values: Parameters<typeof writeStruct>[3]): void {
    const entry = this.#block.entries.find((one) => one.name === name);
    if (entry) writeStruct(this.#view, entry, index, values);
  }
}

type DirectLight = Extract<Light, { type: DirectKind }>;

/**
 * A light without intensity where none of its light can reach anything that the camera sees. That is so where an object
 * parts the two: light does not pass through surfaces, so all of its paths stay on the camera's side of every object.
 */
function dimmed({ camera, objects }: ResolvedScene, light: DirectLight): DirectLight {
  const reaches = objects.every(({ shape }) => {
    const primitive = primitiveOf(shape);
    const camerasSide = primitive.side(shape, camera.position);
    return light.type === 'point'
      ? primitive.side(shape, light.position) === camerasSide
      : primitive.farSide(shape, directionToLight(light)) * camerasSide >= 0;
  });
  return reaches ? light : { ...light, intensity: 0 };
}
