/** Scene and requirements to the bytes of the two uniform blocks: `Scene` (also when the camera moves) and `View`. */
import type { CameraFrame } from './camera-frame.ts';
import { type Frame, powerOfTwoBelow, toFrame } from './frame.ts';
import { lightRecords } from './light-records.ts';
import { materialRecord, packMaterial } from './material-record.ts';
import { primitiveOf, primitives, shapeKinds } from './primitives/index.ts';
import type { Requirements } from './requirements.ts';
import type { ResolvedScene } from './resolve-scene.ts';
import { lightKinds } from './schema.ts';
import { type BlockLayout, layoutBlock, layoutStruct, writeStruct } from './std140.ts';
import { length } from './vector.ts';
import { eyeRecord, packEye, packSurroundings, surroundingsRecord } from './view-record.ts';

/** The blocks that a shader with these requirements reads. */
export function layoutBlocks(required: Requirements): { readonly scene: BlockLayout; readonly view: BlockLayout } {
  const has = (feature: string): boolean => required.features.some((one) => one === feature);
  const struct = (name: string, members: Parameters<typeof layoutStruct>[1]) => layoutStruct(name, members, has);
  const scene = layoutBlock('Scene', [
    ...shapeKinds.map((kind) => ({
      name: arrayName(kind),
      struct: struct(structName(kind), primitives[kind].record),
      count: required.shapes[kind],
    })),
    ...lightKinds.map((kind) => ({
      name: arrayName(lightRecords[kind].struct),
      struct: struct(lightRecords[kind].struct, lightRecords[kind].record),
      count: required.lights[kind],
    })),
    { name: 'materials', struct: struct('Material', materialRecord), count: required.materials },
    { name: 'surroundings', struct: struct('Surroundings', surroundingsRecord) },
  ]);
  return { scene, view: layoutBlock('View', [{ name: 'eye', struct: struct('Eye', eyeRecord) }]) };
}

/** `Sphere` for the kind sphere. */
export const structName = (kind: string): string => `${kind[0]?.toUpperCase()}${kind.slice(1)}`;
/** `spheres` for the kind sphere or the struct Sphere. */
export const arrayName = (kind: string): string => `${kind[0]?.toLowerCase()}${kind.slice(1)}s`;

/** The space that a scene is packed in: its origin is the camera, its unit a power of two near the largest length. */
export function packingFrame({ camera, objects, lights }: ResolvedScene): Frame {
  const unscaled = { origin: camera.position, scale: 1 };
  const lengths = [
    ...objects.map(({ shape }) => primitiveOf(shape).extent(shape, unscaled)),
    ...lights.map((light) => (light.type === 'point' ? length(toFrame(unscaled, light.position)) : 0)),
  ];
  const largest = Math.max(...lengths, 0);
  return { origin: camera.position, scale: largest > 0 ? 1 / powerOfTwoBelow(largest) : 1 };
}

/** The bytes of the block `Scene`. */
export function packScene(scene: ResolvedScene, block: BlockLayout): ArrayBuffer {
  const bytes = new ArrayBuffer(block.size);
  const view = new DataView(bytes);
  const frame = packingFrame(scene);
  const written = new Map<string, number>();
  const write = (name: string, values: Parameters<typeof writeStruct>[3]): void => {
    const entry = block.entries.find((one) => one.name === name);
    const index = written.get(name) ?? 0;
    written.set(name, index + 1);
    if (entry) writeStruct(view, entry, index, values);
  };
  for (const { shape, material } of scene.objects) {
    const checkerSize = scene.materials[material]?.checkerSize ?? 1;
    write(arrayName(shape.type), { ...primitiveOf(shape).pack(shape, frame, checkerSize), material });
  }
  for (const light of scene.lights) {
    const { struct, pack } = lightRecords[light.type] as (typeof lightRecords)['point'];
    write(arrayName(struct), pack(light as Parameters<typeof pack>[0], frame));
  }
  for (const material of scene.materials) write('materials', packMaterial(material, frame.scale));
  write('surroundings', packSurroundings(scene));
  return bytes;
}

/** The bytes of the block `View`. */
export function packView(frame: CameraFrame, block: BlockLayout): ArrayBuffer {
  const bytes = new ArrayBuffer(block.size);
  for (const entry of block.entries) writeStruct(new DataView(bytes), entry, 0, packEye(frame));
  return bytes;
}
