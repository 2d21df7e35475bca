/** The scenes in which the estimate of noise is judged. */
import { readdirSync, statSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { qualities } from '@ray-scene/core';
import { readImageTruth } from '../../truth/images/image-truth.ts';
import { packedImages } from '../../truth/images/packed-image.ts';
import { environmentImages } from '../../truth/images/translate-environment.ts';
import { translateScene } from '../../truth/images/translate-scene.ts';
import { BASE } from '../trade/knobs.ts';
import type { Subject } from './page.ts';

export interface BenchSubject {
  readonly name: string;
  readonly subject: Subject;
}

/** By paths as `balanced` follows them, and as `draft` draws. */
export const gallerySubjects = (
  scenes: readonly { readonly name: string; readonly scene: string }[],
): readonly BenchSubject[] =>
  scenes.flatMap(({ name, scene }) => [
    { name, subject: { scene, images: [], integrator: 'path', bounces: BASE.bounces } },
    { name, subject: { scene, images: [], integrator: 'direct', bounces: qualities.draft.bounces ?? BASE.bounces } },
  ]);

const TRUTH = 'test/truth/data/images';
/** A thousand spheres take a software renderer many minutes to compile. */
const TOO_LONG = ['spheres_1000'];

const bytesOf = async (file: string): Promise<ArrayBuffer> => new Uint8Array(await readFile(file)).buffer;

/** Those of the truth that our language has words for, with as many bounces as theirs. */
export async function truthSubjects(): Promise<readonly BenchSubject[]> {
  const names = readdirSync(TRUTH).filter((name) => statSync(join(TRUTH, name)).isDirectory());
  const subjects = await Promise.all(names.filter((name) => !TOO_LONG.includes(name)).map(truthSubject));
  return subjects.filter((subject) => subject !== undefined);
}

async function truthSubject(name: string): Promise<BenchSubject | undefined> {
  const truth = await readImageTruth((file) => bytesOf(join(TRUTH, name, file)));
  const translated = translateScene(truth.scene);
  if (translated.skipped !== undefined) return undefined;
  const images = await environmentImages(truth.scene, (file) => bytesOf(join(TRUTH, file)));
  const scene = JSON.stringify(translated.scene);
  return {
    name: `truth/${name}`,
    subject: { scene, images: packedImages(images), integrator: 'path', bounces: translated.bounces },
  };
}
