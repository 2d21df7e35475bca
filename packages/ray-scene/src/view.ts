/** What a view shows: which scene, from where, with which settings, how large. Knows no WebGL. */
import {
  type EnvironmentImages,
  frameObjects,
  isSurfaceOutput,
  mergeRequirements,
  parseScene,
  parseSettings,
  type RenderSettings,
  type Requirements,
  type ResolvedCamera,
  type ResolvedScene,
  requirements,
  requirementsKey,
  resolveScene,
  type Scene,
} from '@ray-scene/core';

export class View {
  #scene: Scene = parseScene({});
  #images: EnvironmentImages | undefined;
  #settings = parseSettings();
  #width = 1;
  #height = 1;
  #override: ResolvedCamera | undefined;
  /** The objects as they were when the view was framed: it does not follow them when they move. */
  #framed: Scene['objects'] = [];
  #merged: Requirements | undefined;
  #resolved: ResolvedScene | undefined;
  #revision = 0;

  /** Another number whenever samples of before are of no more use. */
  get revision(): number {
    return this.#revision;
  }

  get settings(): RenderSettings {
    return this.#settings;
  }

  get width(): number {
    return this.#width;
  }

  get height(): number {
    return this.#height;
  }

  /** The camera in use: the override, else the author's, completed so that it shows all objects. */
  get camera(): ResolvedCamera {
    return this.#override ?? frameObjects({ ...this.#scene, objects: this.#framed }, this.#width / this.#height);
  }

  get resolved(): ResolvedScene {
    this.#resolved ??= resolveScene(this.#scene, this.#width / this.#height, this.camera, this.#images);
    return this.#resolved;
  }

  /** What the program must hold: for this scene, and for those before it, so that going back compiles nothing. */
  get required(): Requirements {
    const required = this.#ownRequirements();
    this.#merged = this.#merged ? mergeRequirements(this.#merged, required) : required;
    return this.#merged;
  }

  /** Equal for scenes that require the same, whatever came before them. */
  get key(): string {
    return requirementsKey(this.#ownRequirements());
  }

  /** @param images of its surroundings. */
  setScene(scene: Scene, images?: EnvironmentImages): void {
    if (objectSet(scene.objects) !== objectSet(this.#scene.objects)) this.#framed = scene.objects;
    this.#scene = scene;
    this.#images = images;
    this.#restart();
  }

  set settings(settings: RenderSettings) {
    const before = traced(this.#settings);
    this.#settings = settings;
    if (traced(settings) !== before) this.#restart();
  }

  set override(camera: ResolvedCamera | undefined) {
    // Controls that have come to rest set the same camera again and again.
    if (JSON.stringify(camera) === JSON.stringify(this.#override)) return;
    this.#override = camera;
    this.#restart();
  }

  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    this.#width = width;
    this.#height = height;
    this.#restart();
  }

  /** Lets go of what only earlier scenes required. */
  forget(): void {
    this.#merged = undefined;
  }

  #ownRequirements(): Requirements {
    return requirements(this.resolved, this.#settings);
  }

  #restart(): void {
    this.#resolved = undefined;
    this.#revision++;
  }
}

/** Equal for settings that give the same samples. */
const traced = ({ bounces, integrator, seed, output, clamp }: RenderSettings): string =>
  `${[bounces, integrator, seed, clamp, isSurfaceOutput(output) && output]}`;

/** Equal for lists of the same objects, whatever their numbers. */
const objectSet = (objects: Scene['objects']): string =>
  JSON.stringify(objects.map((node) => [node.type, node.name, node.type === 'group' ? objectSet(node.objects) : '']));
