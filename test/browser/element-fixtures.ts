/** Helpers for tests of `<ray-scene>` in a page. */
import { fixture } from '@open-wc/testing';
import type { RayScene, SceneElementTagNameMap } from '../../packages/ray-scene/src/index.ts';
import '../../packages/ray-scene/src/index.ts';

/** A small picture of few samples, with this content. */
export const sceneWith = (content: string, attributes = ''): Promise<RayScene> =>
  fixture<RayScene>(`<ray-scene style="width: 60px" samples="2" pixel-ratio="1" ${attributes}>${content}</ray-scene>`);

/** What is said on the console from now on, instead of saying it. To be called once per test, and restored after it. */
export class QuietConsole {
  readonly lines: string[] = [];
  readonly #original = console.error;

  constructor() {
    console.error = (...args: unknown[]) => this.lines.push(args.join(' '));
  }

  restore(): void {
    console.error = this.#original;
  }
}

export const nextFrame = (): Promise<number> => new Promise(requestAnimationFrame);

/** Long enough for every edit to be read and drawn. */
export async function someFrames(count = 3): Promise<void> {
  for (let i = 0; i < count; i++) await nextFrame();
}

/** Waits until something holds, for as long as the test may take: how fast this machine is, is not what is tested. */
export async function until(holds: () => unknown): Promise<void> {
  while (!holds()) await new Promise((resolve) => setTimeout(resolve, 10));
}

/** Waits until an element shows no more progress. */
export async function untilAtRest(element: EventTarget): Promise<void> {
  const progress = countEvents(element, 'progress');
  do {
    progress.count = 0;
    await someFrames(5);
  } while (progress.count > 0);
}

/** Counts how often an event of an element comes. */
export function countEvents(element: EventTarget, type: string): { count: number } {
  const counter = { count: 0 };
  element.addEventListener(type, () => counter.count++);
  return counter;
}

/** The text that is laid over the picture, or undefined if it is not to be seen. */
export function overlayOf(element: RayScene): string | undefined {
  const overlay = element.shadowRoot?.querySelector<HTMLElement>('[part=error]');
  return overlay?.checkVisibility?.() === false || overlay?.hidden ? undefined : overlay?.textContent?.trim();
}

/** Why a promise was rejected. */
export const rejection = (promise: Promise<unknown>): Promise<Error> =>
  promise.then(
    () => Promise.reject(new Error('was resolved')),
    (error: Error) => error,
  );

export const canvasIn = (element: RayScene): HTMLCanvasElement =>
  element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;

/** The bytes of the pixel in the middle of the picture. */
export function middlePixel(element: RayScene): readonly number[] {
  const canvas = canvasIn(element);
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  return [...context.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data];
}

/** The first part of a scene with this tag. */
export function partOf<Tag extends keyof SceneElementTagNameMap>(
  element: RayScene,
  tag: Tag,
): SceneElementTagNameMap[Tag] {
  const part = element.querySelector(tag);
  if (!part) throw new Error(`the scene has no <${tag}>`);
  return part;
}
