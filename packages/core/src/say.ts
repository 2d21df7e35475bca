/** The sentences of `problem-texts.ts` for those who find something wrong. */
import type { ProblemTexts } from './problem-texts.ts';
import type { lengthProblems as problems } from './scene-lengths.ts';

/** What there is to say. */
interface Speech {
  readonly texts: ProblemTexts;
  readonly nearestWord: (typed: string, words: Iterable<string>) => string | undefined;
  readonly lengthProblems: typeof problems;
}

let speech: Speech | undefined;

/** Makes the sentences known. */
export function registerSpeech(all: Speech): void {
  speech = all;
}

/** What is wrong, in a sentence; in key words as long as the sentences are not loaded. */
export function say<K extends keyof ProblemTexts>(problem: K, ...about: Parameters<ProblemTexts[K]>): string {
  const text = speech?.texts[problem] as ((...about: Parameters<ProblemTexts[K]>) => string) | undefined;
  return text ? text(...about) : [problem, ...about].join(' ');
}

/** Whether someone may have meant one of the words, and which one; as long as nobody can tell, the first. */
export const meantWord = (typed: string, words: readonly string[]): string | undefined =>
  speech ? speech.nearestWord(typed, words) : words[0];

/** What is wrong with how lengths go together; as long as nobody can tell, the scene as a whole. */
export const lengthProblems: typeof problems = (...about) =>
  speech ? speech.lengthProblems(...about) : [{ path: [], where: '', message: 'farApart' }];
