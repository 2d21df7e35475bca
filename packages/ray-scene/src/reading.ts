/** What a source says, and what is wrong with that. */
import {
  type EnvironmentImages,
  type Locate,
  type Problem,
  parseScene,
  type Scene,
  SceneError,
  type SourceWords,
} from '@ray-scene/core';
import type { Markup } from './read-markup.ts';

/** What the source says. */
export interface Reading {
  /** Which kind of source, and its address if it has one: from another origin comes another scene, not an edit. */
  readonly origin: string;
  readonly scene?: Scene;
  readonly problems: readonly Problem[];
  /** If it was read from child elements. */
  readonly markup?: Markup;
  /** Those that the scene names. */
  readonly images?: EnvironmentImages;
  /** How it tells where a problem is. */
  readonly locate?: Locate | undefined;
}

/** Where and how images are asked for that a scene names. */
export interface ImageBase {
  /** What their addresses are relative to. */
  readonly url: string;
  readonly credentials: RequestCredentials;
}

/** What comes of an input, and of what was `found` to be wrong with it before. */
export function judge(origin: string, input: unknown, words?: SourceWords, found: readonly Problem[] = []): Reading {
  try {
    const scene = parseScene(input, words);
    return found.length > 0 ? { origin, problems: found } : { origin, scene, problems: [], locate: words?.locate };
  } catch (error) {
    if (!(error instanceof SceneError)) throw error;
    return { origin, problems: [...found, ...error.problems] };
  }
}

/** An address that is none is left for `fetch` to complain about. */
export function absolute(address: string, base: string): string {
  try {
    return new URL(address, base).href;
  } catch {
    return address;
  }
}
