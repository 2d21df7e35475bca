/** The images that a scene names, from their addresses. Loaded with the first scene that names one. */
import {
  type EnvironmentImage,
  jsonPath,
  type Locate,
  type Problem,
  readRadianceImage,
  type Scene,
} from '@ray-scene/core';
import { Download } from './download.ts';
import { absolute, type ImageBase, type Reading } from './reading.ts';

/** A place where a scene names an image. */
interface Wanted {
  readonly path: Problem['path'];
  readonly field: string;
  /** What the field takes. */
  readonly what: string;
  /** As the author wrote it. */
  readonly address: string;
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

  #wanted({ environment }: Scene, base: ImageBase): readonly Wanted[] {
    const address = environment?.src;
    if (!address) return [];
    const download = this.#download(address, base);
    return [{ path: ['environment'], field: 'src', what: 'a Radiance .hdr image', address, download }];
  }

  #download(address: string, { url: base, credentials }: ImageBase): Download<EnvironmentImage> {
    const url = absolute(address, base);
    const present = this.#downloads.find((one) => one.url === url && one.credentials === credentials);
    return present ?? new Download(url, credentials, readImage, this.#changed);
  }
}

const readImage = async (answer: Response): Promise<EnvironmentImage> =>
  readRadianceImage(new Uint8Array(await answer.arrayBuffer()));

function problemOf({ path, field, what, address, download }: Wanted, locate: Locate = jsonPath): readonly Problem[] {
  const { url, result } = download;
  if (!result || 'value' in result) return [];
  const message = `${field} must be the address of ${what}, not "${address}": ${url} ${result.problem}`;
  return [{ path, where: locate(path), message }];
}
