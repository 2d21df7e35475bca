import type { ReactiveController, ReactiveControllerHost } from '@lit/reactive-element';
import { jsonPath, namesImages, type Scene, type SourceWords, say } from '@ray-scene/core';
import { Download } from './download.ts';
import { isSceneMarkup, readMarkup } from './read-markup.ts';
import { absolute, judge, type Reading } from './reading.ts';
import type { SceneImages } from './scene-images.ts';

export interface SourceHost extends ReactiveControllerHost, HTMLElement {
  readonly src: string | null;
  readonly crossOrigin: string | null;
}

/** Where the scene comes from: the last one assigned, else `src`, else an inline script, else child elements. */
export class SceneSource implements ReactiveController {
  readonly #host: SourceHost;
  readonly #changed: () => void;
  readonly #failed: (error: Error) => void;
  #observer: MutationObserver | undefined;
  #assigned: unknown;
  #download: Download<string> | undefined;
  #images: SceneImages | undefined;
  #stale = true;
  /** Whether something has yet to arrive. */
  #waits = false;

  /**
   * @param changed told when there is, or will be, something to read.
   * @param failed told when a part of the program could not be loaded.
   */
  constructor(host: SourceHost, changed: () => void, failed: (error: Error) => void) {
    this.#host = host;
    this.#changed = changed;
    this.#failed = failed;
    host.addController(this);
  }

  /** Whether there is, or will be, something new to read. */
  get pending(): boolean {
    return this.#stale || this.#waits;
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
    if (!loading) return false;
    this.#waits = true;
    loading.then(() => this.touch());
    return true;
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
    const reading = this.#read();
    const whole = reading?.scene && namesImages(reading.scene) ? this.#withImages(reading, reading.scene) : reading;
    this.#waits = !whole;
    return whole;
  }

  #read(): Reading | undefined {
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
    this.#images?.cancel();
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
      return { origin: 'several', problems: [{ path: [], where: localName, message: say('severalScenes', sources) }] };
    }
    if (src) return this.#downloaded(src);
    this.#stop();
    if (scripts[0]) return judge('script', scripts[0].textContent, jsonIn(`${localName} > script`));
    const markup = readMarkup(this.#host);
    return { ...judge('children', markup.input, markup.words, markup.problems), markup };
  }

  #downloaded(src: string): Reading | undefined {
    const url = absolute(src, this.#host.baseURI);
    const credentials = this.#credentials;
    if (this.#download?.url !== url || this.#download.credentials !== credentials) {
      this.#stop();
      this.#download = new Download(
        url,
        credentials,
        (answer) => answer.text(),
        () => this.touch(),
      );
    }
    const { result } = this.#download;
    if (!result) return undefined;
    if ('value' in result) return judge(url, result.value, jsonIn(url));
    return { origin: url, problems: [{ path: [], where: url, message: result.problem }] };
  }

  /** The reading of a scene that names images, when they are there. */
  #withImages(reading: Reading, scene: Scene): Reading | undefined {
    const base = { url: this.#download?.url ?? this.#host.baseURI, credentials: this.#credentials };
    if (this.#images) return this.#images.complete(reading, scene, base);
    import('./scene-images.ts').then(({ SceneImages }) => {
      this.#images ??= new SceneImages(() => this.touch());
      this.touch();
    }, this.#failed);
    return undefined;
  }

  get #credentials(): RequestCredentials {
    return this.#host.crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  }

  #stop(): void {
    this.#download?.cancel();
    this.#download = undefined;
  }
}

/** Words for a JSON text that stands somewhere: `scenes/a.json objects[2].radius`. */
const jsonIn = (place: string): SourceWords => ({
  locate: (path) => (path.length > 0 ? `${place} ${jsonPath(path)}` : place),
  field: 'key',
  spell: (field) => field,
});

const isJsonScript = (element: Element): boolean => element.matches('script[type="application/json"]');

/** Whether the parser of the page is past the end of a node. */
function isParsed(node: Node): boolean {
  if (document.readyState !== 'loading') return true;
  for (let above: Node | null = node; above; above = above instanceof ShadowRoot ? above.host : above.parentNode) {
    if (above.nextSibling) return true;
  }
  return false;
}
