/** The images that a scene names, from their addresses. Loaded with the first scene that names one. */
import {
  type EnvironmentImage,
  jsonPath,
  type Locate,
  type Problem,
  radianceImageByRows,
  type Scene,
  type SceneNode,
} from '@ray-scene/core';
import { decodeImage } from './decode-image.ts';
import { Download } from './download.ts';
import { inPieces } from './in-pieces.ts';
import { absolute, type ImageBase, type Reading } from './reading.ts';

/** What a field takes. */
interface ImageKind {
  readonly field: string;
  readonly what: string;
  readonly read: (answer: Response) => Promise<EnvironmentImage>;
}

const SURROUNDINGS: ImageKind = {
  field: 'src',
  what: 'a Radiance .hdr image',
  read: async (answer) => {
    const image = await inPieces(radianceImageByRows(new Uint8Array(await answer.arrayBuffer())));
    // What takes longest is in store then, before the scene asks for it. It comes with what the scene needs next.
    await inPieces((await import('./scene-textures.ts')).imageTableByRows(image));
    return image;
  },
};

const MAP: ImageKind = {
  field: 'map',
  what: 'an image',
  read: async (answer) => decodeImage(await answer.blob()),
};

/** A place where a scene names an image. */
interface Named {
  readonly path: Problem['path'];
  readonly kind: ImageKind;
  /** As the author wrote it. */
  readonly address: string;
}

interface Wanted extends Named {
  readonly download: Download<EnvironmentImage>;
}

/** Keeps the images of the present scene, so that its edits ask for none again. */
export class SceneImages {
  readonly #changed: () => void;
  #downloads: readonly Download<EnvironmentImage>[] = [];

  /** @param changed told when another image is there, or is known not to come. */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /** A reading with its images, or with what is wrong with them; undefined as long as some are on their way. */
  complete(reading: Reading, scene: Scene, base: ImageBase): Reading | undefined {
    const wanted = this.#wanted(scene, base);
    const downloads = wanted.map(({ download }) => download);
    for (const one of this.#downloads) if (!downloads.includes(one)) one.cancel();
    this.#downloads = downloads;
    if (downloads.some(({ result }) => !result)) return undefined;
    const problems = wanted.flatMap((one) => problemOf(one, reading.locate));
    if (problems.length > 0) return { origin: reading.origin, problems };
    const images = wanted.map(({ address, download: { result } }) => [
      address,
      result && 'value' in result && result.value,
    ]);
    return { ...reading, images: new Map(images as [string, EnvironmentImage][]) };
  }

  /** Stops waiting: what is not there yet is asked for again when it is wanted again. */
  cancel(): void {
    for (const download of this.#downloads) if (!download.result) download.cancel();
    this.#downloads = this.#downloads.filter(({ result }) => result);
  }

  /** An image that is named twice is asked for once. */
  #wanted(scene: Scene, base: ImageBase): readonly Wanted[] {
    const wanted: Wanted[] = [];
    for (const named of namedImages(scene)) {
      const url = absolute(named.address, base.url);
      const isWanted = (one: Download<EnvironmentImage>): boolean =>
        one.url === url && one.credentials === base.credentials && one.read === named.kind.read;
      const present = [...this.#downloads, ...wanted.map(({ download }) => download)].find(isWanted);
      const download = present ?? new Download(url, base.credentials, named.kind.read, this.#changed);
      wanted.push({ ...named, download });
    }
    return wanted;
  }
}

/** Where a scene names images, and which. */
function namedImages({ environment, materials, objects }: Scene): readonly Named[] {
  const src = environment?.src;
  return [
    ...(src ? [{ path: ['environment'], kind: SURROUNDINGS, address: src }] : []),
    ...Object.entries(materials).flatMap(([name, { map }]) => mapAt(['materials', name], map)),
    ...mapsOf(objects, ['objects']),
  ];
}

const mapsOf = (nodes: readonly SceneNode[], path: Problem['path']): readonly Named[] =>
  nodes.flatMap((node, i) =>
    node.type === 'group' ? mapsOf(node.objects, [...path, i, 'objects']) : mapAt([...path, i], node.map),
  );

const mapAt = (path: Problem['path'], address: string | undefined): readonly Named[] =>
  address ? [{ path, kind: MAP, address }] : [];

function problemOf(
  { path, kind: { field, what }, address, download }: Wanted,
  locate: Locate = jsonPath,
): readonly Problem[] {
  const { url, result } = download;
  if (!result || 'value' in result) return [];
  const message = `${field} must be the address of ${what}, not "${address}": ${url} ${result.problem}`;
  return [{ path, where: locate(path), message }];
}
