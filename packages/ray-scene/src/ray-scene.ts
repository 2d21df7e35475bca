import type { PropertyDeclarations, PropertyValues } from '@lit/reactive-element';
import {
  type EnvironmentImages,
  frameObjects,
  type Problem,
  parseScene,
  type ResolvedCamera,
  type Scene,
  SceneError,
} from '@ray-scene/core';
import { adoptStyles } from './adopt-styles.ts';
import { type CanvasHost, CanvasSize, canvasOf } from './canvas-size.ts';
import { adoptEarlyProperties, attributeOf } from './field-properties.ts';
import { type Frame, FrameLoop } from './frame-loop.ts';
import { Orbit, type OrbitHost } from './orbit.ts';
import type { Picked } from './pick.ts';
import { Picture } from './picture.ts';
import { Pointing } from './pointing.ts';
import { ProgressReport } from './progress-report.ts';
import type { Markup } from './read-markup.ts';
import { judge, type Reading } from './reading.ts';
import { type RenderStats, WebGLUnavailableError } from './renderer.ts';
import { ErrorReport } from './report.ts';
import type { SceneHost } from './scene-elements.ts';
import { SettingsElement } from './settings-element.ts';
import { ShadowTree } from './shadow-tree.ts';
import { SceneSource, type SourceHost } from './source.ts';
import { StatsDisplay } from './stats-display.ts';
import { styles } from './styles.ts';

const flag = (attribute: string) => ({ attribute, type: Boolean, reflect: true });

/**
 * A ray-traced view of a scene.
 *
 * @slot - The scene: `<ray-sphere>` and the others, or one `<script type="application/json">`. Any other content is
 * shown instead of the picture where there is no WebGL2.
 * @slot poster - Shown until there is a picture.
 * @csspart canvas - The picture.
 * @csspart poster - What is shown until there is a picture.
 * @csspart error - What is wrong, in words.
 * @csspart stats - The panel of `show-stats`.
 * @csspart stats-curve - Its curve of error against time.
 * @cssprop --ray-scene-error-color - Of the text that says what is wrong.
 * @cssprop --ray-scene-error-background - Behind that text.
 * @cssprop --ray-scene-stats-color - Of the text and the curve of `show-stats`.
 * @cssprop --ray-scene-stats-background - Behind them.
 * @cssprop --ray-scene-focus-ring - The outline of what has the focus.
 */
export class RayScene extends SettingsElement implements CanvasHost, OrbitHost, SceneHost, SourceHost {
  static override readonly properties: PropertyDeclarations = {
    src: {},
    crossOrigin: {},
    alt: {},
    poster: {},
    background: {},
    loading: { reflect: true, useDefault: true },
    cameraControls: flag('camera-controls'),
    autoRotate: flag('auto-rotate'),
    paused: flag('paused'),
    showStats: flag('show-stats'),
  };

  /** Address of a scene as JSON. */
  declare src: string | null;
  /** As on `<img>`: with `use-credentials`, cookies are sent to other origins too. */
  declare crossOrigin: string | null;
  /**
   * What the picture shows, in words; null: the name of the scene. Empty: as on `<img>`, nothing that has to be told, but
   * with `camera-controls`, as what can have the focus must have a name.
   */
  declare alt: string | null;
  /** Address of an image, shown until there is a picture. */
  declare poster: string | null;
  /** Replaces the background of the scene: a CSS colour, linear [r, g, b], `environment` or `transparent`. */
  declare background: string | readonly [number, number, number] | null;
  /** With `lazy` nothing is loaded before the element comes into sight. */
  declare loading: 'eager' | 'lazy';
  /** Whether people can look around by pointer, wheel and keyboard. */
  declare cameraControls: boolean;
  /** Whether the camera walks around the scene, unless the reader of the page wants no motion. */
  declare autoRotate: boolean;
  /** Whether the picture stays as it is but for edits. */
  declare paused: boolean;
  /** Whether a panel tells how far the picture is, what it cost, and how noisy it is. */
  declare showStats: boolean;

  readonly #source = new SceneSource(
    this,
    () => this.#sceneChanged(),
    (error) => this.#fail(error),
  );
  readonly #loop = new FrameLoop(this, (frame) => this.#frame(frame));
  readonly #size = new CanvasSize(this, () => this.#viewChanged());
  readonly #orbit = new Orbit(this, () => this.#viewChanged());
  readonly #report = new ErrorReport(this);
  readonly #progress = new ProgressReport(this);
  #shadow: ShadowTree | undefined;
  #picture: Picture | undefined;
  #reading: Reading | undefined;
  /** What is wrong with the attributes of the element itself. */
  #ownProblems: readonly Problem[] = [];
  /** The last good scene, its images and its JSON, and where it came from. */
  #scene: Scene | undefined;
  #images: EnvironmentImages | undefined;
  #json = '';
  #origin = '';
  #markup: Markup | undefined;
  /** What keeps the scene from being drawn. */
  #failure: Error | undefined;
  /** Whether something on the element itself has changed. */
  #stale = true;
  /** A camera that was set before there was a picture. */
  #wanted: Partial<ResolvedCamera> | undefined;
  #hasBeenSeen = false;
  #hasPicture = false;

  constructor() {
    super();
    this.src = this.crossOrigin = this.alt = this.poster = this.background = null;
    this.cameraControls = this.autoRotate = this.paused = this.showStats = false;
    this.loading = 'eager';
  }

  /** The scene that is shown. Takes a scene, as an object or as JSON text, which goes before any other source. */
  get scene(): Scene | undefined {
    return this.#scene;
  }

  set scene(scene: object | string | null | undefined) {
    this.#progress.expectLoad();
    this.#source.assign(scene);
  }

  /** The camera of the picture. One that is set stands in for the scene's, until the author edits that. */
  get camera(): ResolvedCamera | undefined {
    return this.#orbit.override ?? this.#picture?.camera;
  }

  set camera(camera: Partial<ResolvedCamera> | undefined) {
    const whole = parseScene({ camera: { ...this.camera, ...camera } });
    // As long as there is no picture, nobody knows what to put for what is left out.
    this.#wanted = this.camera ? undefined : camera && { ...this.#wanted, ...camera };
    this.#orbit.reset(this.camera && camera && frameObjects(whole, 1));
  }

  /** Goes back to the scene's own camera. */
  resetCamera(): void {
    this.camera = undefined;
  }

  /** Resolves when the scene, as it is now, is seen; rejects if it cannot be. */
  get ready(): Promise<void> {
    this.#flush();
    return this.#progress.ready.promise;
  }

  /** Resolves when the picture has all its samples. */
  get complete(): Promise<void> {
    this.#flush();
    return this.#progress.complete.promise;
  }

  /** What the picture is made of so far, and what it cost; undefined before there is one. */
  get stats(): RenderStats | undefined {
    return this.#picture?.stats;
  }

  /** The picture as an image file, once there is one. */
  async toBlob(type?: string, quality?: number): Promise<Blob> {
    await this.ready;
    const blob = await new Promise<Blob | null>((done) => canvasOf(this)?.toBlob(done, type, quality));
    if (!blob) throw new Error(`This browser makes no ${type ?? 'image'} of a canvas`);
    return blob;
  }

  /** The linear radiance of the picture: RGBA premultiplied, the top row first; empty before there is one. */
  readRadiance(): Float32Array {
    return this.#picture?.readRadiance() ?? new Float32Array();
  }

  /** What is seen at a point of the page, in client coordinates as those of a pointer event; where there is anything. */
  async pick(x: number, y: number): Promise<Picked | undefined> {
    const box = canvasOf(this)?.getBoundingClientRect();
    await this.ready;
    return box && (await import('./pick.ts')).pick(this, box, x, y);
  }

  /** The child element that a node of the scene, as ['objects', 2], was read from. */
  elementOf(path: Problem['path']): Element | undefined {
    return this.#markup?.elementOf(path);
  }

  /** For the elements of the scene. */
  markupChanged(): void {
    this.#source.touch();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    adoptStyles(this.renderRoot as ShadowRoot, styles);
    adoptEarlyProperties(this, [...Object.keys(this.fields), 'scene', 'camera']);
    this.#failure = undefined;
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#picture?.dispose();
    this.#picture = undefined;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('src') || changed.has('crossOrigin')) this.#source.touch();
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    const root = super.createRenderRoot() as ShadowRoot;
    this.#shadow = new ShadowTree(root);
    new Pointing(this, this.#shadow.canvas);
    new StatsDisplay(this, root);
    return root;
  }

  protected override update(changed: PropertyValues<this>): void {
    super.update(changed);
    const name = this.#scene?.name || 'Ray-traced scene';
    this.#shadow?.show({
      label: this.cameraControls ? this.alt || name : (this.alt ?? name),
      keys: this.cameraControls,
      hasWebGL: !this.#lacksWebGL,
      hasPicture: this.#hasPicture,
      poster: this.poster,
    });
  }

  protected override updated(): void {
    this.#stale = true;
    this.#viewChanged();
  }

  get #lacksWebGL(): boolean {
    return this.#failure instanceof WebGLUnavailableError;
  }

  #sceneChanged(): void {
    this.#progress.ready.renew();
    this.#viewChanged();
  }

  #viewChanged(): void {
    this.#progress.complete.renew();
    this.#loop.request();
  }

  /** Whoever asks for a promise has made all edits that it is to be about, even those that are yet to be noticed. */
  #flush(): void {
    this.#source.flush();
    if (this.isUpdatePending) this.#sceneChanged();
  }

  #frame(frame: Frame): boolean {
    this.#hasBeenSeen ||= frame.visible || this.loading !== 'lazy';
    if (!this.#hasBeenSeen) return false;
    this.#update();
    return frame.visible && this.#scene !== undefined && this.#draw(this.#scene, frame);
  }

  #update(): void {
    const reading = this.#source.read();
    if (!reading && !this.#stale) return;
    this.#stale = false;
    this.#reading = reading ?? this.#reading;
    const words = { locate: () => this.localName, field: 'attribute', spell: attributeOf };
    const own = judge('attributes', { background: this.background ?? undefined }, words);
    this.#ownProblems = [...this.attributeProblems, ...own.problems];
    const { scene, origin, markup, images } = this.#reading ?? {};
    if (this.#problems.length > 0 && this.#source.readAfter(this.#report.load())) return;
    if (scene && origin) {
      this.#markup = markup;
      this.#adopt(scene, origin, own.scene?.background, images);
    }
    this.#tell();
  }

  #adopt(parsed: Scene, origin: string, background: Scene['background'], images?: EnvironmentImages): void {
    const scene = background ? { ...parsed, background } : parsed;
    const isOther = origin !== this.#origin;
    const before = this.#scene;
    this.#origin = origin;
    if (isOther) this.#progress.expectLoad();
    // From elsewhere, the same address is another image.
    const json = JSON.stringify([scene, images && origin]);
    // Setting the same scene anew would throw its samples away.
    if (json === this.#json) return;
    this.#json = json;
    this.#scene = scene;
    this.#images = images;
    if (before && (isOther || JSON.stringify(before.camera) !== JSON.stringify(scene.camera))) this.#orbit.reset();
    if (before?.name !== scene.name) this.requestUpdate();
  }

  get #problems(): readonly Problem[] {
    return [...this.#ownProblems, ...(this.#reading?.problems ?? [])];
  }

  #tell(): void {
    const problems = this.#problems;
    const error = this.#failure ?? (problems.length > 0 ? new SceneError(problems) : undefined);
    const loading = error && this.#report.load();
    if (loading) {
      loading.then(() => this.#tell());
      return;
    }
    this.#report.tell(error);
    const shows = !this.#failure && (this.#source.pending || !this.#reading || this.#reading.scene);
    if (error && !shows) this.#progress.fail(error);
  }

  #fail(error: Error): void {
    this.#failure = error;
    this.requestUpdate();
    this.#tell();
  }

  #draw(scene: Scene, { seconds, sharers }: Frame): boolean {
    const { settings, paused } = this;
    const size = this.#size.measure(settings.pixelRatio);
    const picture = size[0] * size[1] > 0 ? this.#openPicture() : undefined;
    if (!picture) return false;
    picture.show(scene, this.#images, settings, size);
    const wanted = this.#wanted;
    this.#wanted = undefined;
    if (wanted) this.camera = wanted;
    const turns = !paused && this.#orbit.turn(seconds);
    const progress = picture.draw(this.#orbit.override, paused ? 0 : settings.frameBudget / sharers);
    // The program is being compiled, the context is lost, or the scene cannot be drawn.
    if (progress.samples === 0 && !progress.shown) return progress.more;
    if (this.#failure) {
      this.#failure = undefined;
      this.requestUpdate();
      this.#tell();
    }
    if (!this.#hasPicture) this.requestUpdate();
    this.#hasPicture = true;
    const isCurrent = !this.#source.pending && this.#reading?.scene;
    this.#progress.tell(progress, settings.samples, isCurrent ? scene : undefined);
    return !paused && (turns || progress.more);
  }

  #openPicture(): Picture | undefined {
    const canvas = canvasOf(this);
    if (!canvas || this.#lacksWebGL) return undefined;
    const onerror = (error: Error) => this.#fail(error);
    this.#picture ??= Picture.open(canvas, onerror, () => this.#viewChanged());
    return this.#picture;
  }
}
