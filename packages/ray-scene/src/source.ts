import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';
import { jsonPath, type Problem, parseScene, type Scene, SceneError, type SourceWords } from '@ray-scene/core';
import { Download } from './download.ts';
import { isSceneMarkup, type Markup, readMarkup } from './read-markup.ts';

export interface SourceHost extends ReactiveControllerHost, HTMLElement {
  readonly src: string | null;
  readonly crossOrigin: string | null;
}

/** What the source says. */
export interface Reading {
  /** Which kind of source, and its address if it has one: from another origin comes another scene, not an edit. */
  readonly origin: string;
  readonly scene?: Scene;
  readonly problems: readonly Problem[];
  /** If it was read from child elements. */
  readonly markup?: Markup;
}

/** Where the scene comes from: the last one assigned, else `src`, else an inline script, else child elements. */
export class SceneSource implements ReactiveController {
  readonly #host: SourceHost;
  readonly #changed: () => void;
  #observer: MutationObserver | undefined;
  #assigned: unknown;
  #download: Download | undefined;
  #stale = true;
  /** What it takes to read the source rightly. */
  #loading: Promise<unknown> | undefined;
  #isBeyondHelp = false;

  constructor(host: SourceHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
    host.addController(this);
  }

  /** Whether there is, or will be, something new to read. */
  get pending(): boolean {
    return this.#stale || this.#loading !== undefined || (this.#download !== undefined && !this.#download.result);
  }

  assign(scene: unknown): void {
    this.#assigned = scene ?? undefined;
    this.touch();
  }

  /** Something about the source may have changed. */
  touch(): void {
    this.#stale = true;
    this.#changed();
  }

  /** Reads all of it again when something is there that may make it right. Returns whether to wait for that. */
  readAfter(loading: Promise<unknown> | undefined): boolean {
    if (this.#isBeyondHelp) return false;
    this.#loading ??= loading
      ?.catch((error: Error) => {
        this.#isBeyondHelp = true;
        reportError(error);
      })
      .then(() => {
        this.#loading = undefined;
        this.touch();
      });
    return this.#loading !== undefined;
  }

  /** Takes note of edits that the browser has not told of yet. */
  flush(): void {
    if (this.#observer?.takeRecords().length) this.touch();
  }

  /** What there is to read, or undefined if it is not there yet or nothing has changed. */
  read(): Reading | undefined {
    this.flush();
    if (!this.#stale) return undefined;
    this.#stale = false;
    if (this.#assigned !== undefined) {
      this.#stop();
      return judge('scene property', this.#assigned);
    }
    if (isParsed(this.#host)) return this.#declared();
    this.touch();
    return undefined;
  }

  hostConnected(): void {
    this.#observer = new MutationObserver(() => this.touch());
    this.#observer.observe(this.#host, { attributes: true, characterData: true, childList: true, subtree: true });
    this.touch();
  }

  hostDisconnected(): void {
    this.#observer?.disconnect();
    if (!this.#download?.result) this.#stop();
  }

  #declared(): Reading | undefined {
    const { src, children, localName } = this.#host;
    const scripts = [...children].filter(isJsonScript);
    const elements = [...children].filter(isSceneMarkup);
    const sources = [
      ...(src ? ['src'] : []),
      ...scripts.map(() => 'an inline script'),
      ...(elements.length > 0 ? ['child elements'] : []),
    ];
    if (sources.length > 1) {
      const message = `has ${sources.length} scenes: ${sources.join(', ')}. Keep one of them.`;
      return { origin: 'several', problems: [{ path: [], where: localName, message }] };
    }
    if (src) return this.#downloaded(src);
    this.#stop();
    if (scripts[0]) return judge('script', scripts[0].textContent, jsonIn(`${localName} > script`));
    const markup = readMarkup(this.#host);
    return { ...judge('children', markup.input, markup.words, markup.problems), markup };
  }

  #downloaded(src: string): Reading | undefined {
    const url = absolute(src, this.#host.baseURI);
    const credentials = this.#host.crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
    if (this.#download?.url !== url || this.#download.credentials !== credentials) {
      this.#stop();
      this.#download = new Download(url, credentials, () => this.touch());
    }
    const { result } = this.#download;
    if (!result) return undefined;
    if ('text' in result) return judge(url, result.text, jsonIn(url));
    return { origin: url, problems: [{ path: [], where: url, message: result.problem }] };
  }

  #stop(): void {
    this.#download?.cancel();
    this.#download = undefined;
  }
}

/** What comes of an input, and of what was `found` to be wrong with it before. */
export function judge(origin: string, input: unknown, words?: SourceWords, found: readonly Problem[] = []): Reading {
  try {
    const scene = parseScene(input, words);
    return found.length > 0 ? { origin, problems: found } : { origin, scene, problems: [] };
  } catch (error) {
    if (!(error instanceof SceneError)) throw error;
    return { origin, problems: [...found, ...error.problems] };
  }
}

/** Words for a JSON text that stands somewhere: `scenes/a.json objects[2].radius`. */
const jsonIn = (place: string): SourceWords => ({
  locate: (path) => (path.length > 0 ? `${place} ${jsonPath(path)}` : place),
  field: 'key',
  spell: (field) => field,
});

const isJsonScript = (element: Element): boolean =>
  element instanceof HTMLScriptElement && element.type === 'application/json';

/** An address that is none is left for `fetch` to complain about. */
function absolute(address: string, base: string): string {
  try {
    return new URL(address, base).href;
  } catch {
    return address;
  }
}

/** Whether the parser of the page is past the end of a node. */
function isParsed(node: Node): boolean {
  if (document.readyState !== 'loading') return true;
  for (let above: Node | null = node; above; above = above instanceof ShadowRoot ? above.host : above.parentNode) {
    if (above.nextSibling) return true;
  }
  return false;
}
