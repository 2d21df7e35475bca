/** What `<ray-scene>` tells. As on `<img>`, none of these events bubbles or leaves a shadow tree. */
import { type Problem, type Scene, SceneError } from '@ray-scene/core';
import type { StopReason } from './renderer.ts';

/** The first picture of a scene is shown. Edits of that scene give no further `load`. */
export class RaySceneLoadEvent extends Event {
  readonly scene: Scene;

  constructor(scene: Scene) {
    super('load');
    this.scene = scene;
  }
}

/** Something is wrong with the scene, its settings or the machine; the last good picture stays. */
export class RaySceneErrorEvent extends Event {
  readonly error: Error;

  constructor(error: Error) {
    super('error');
    this.error = error;
  }

  /** What is wrong, one by one; empty when `error` is not about the scene. */
  get problems(): readonly Problem[] {
    return this.error instanceof SceneError ? this.error.problems : [];
  }
}

/** Samples were added to the picture. */
export class RaySceneProgressEvent extends Event {
  /** Samples per pixel that the picture has, in the mean. */
  readonly samples: number;
  /** Samples per pixel that it will have. */
  readonly total: number;

  constructor(type: 'progress' | 'complete', samples: number, total: number) {
    super(type);
    this.samples = samples;
    this.total = total;
  }
}

/** The picture is complete. */
export class RaySceneCompleteEvent extends RaySceneProgressEvent {
  /** The rule that came first: all samples, noise as low as asked for, or the time was up. */
  readonly reason: StopReason;
  /** How noisy it is, as `stats.error`; undefined where that cannot be known, as of a single sample. */
  readonly error: number | undefined;

  constructor(samples: number, total: number, reason: StopReason, error: number | undefined) {
    super('complete', samples, total);
    this.reason = reason;
    this.error = error;
  }
}

interface OwnEvents {
  load: RaySceneLoadEvent;
  error: RaySceneErrorEvent;
  progress: RaySceneProgressEvent;
  complete: RaySceneCompleteEvent;
}

/** All events of `<ray-scene>` by name. */
export type RaySceneEventMap = Omit<HTMLElementEventMap, keyof OwnEvents> & OwnEvents;

type Listener<K extends keyof RaySceneEventMap> = (event: RaySceneEventMap[K]) => unknown;

/** Listening, with the types of the events. */
export interface RaySceneEvents {
  addEventListener<K extends keyof RaySceneEventMap>(
    type: K,
    listener: Listener<K>,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<K extends keyof RaySceneEventMap>(
    type: K,
    listener: Listener<K>,
    options?: boolean | EventListenerOptions,
  ): void;
}
