/** What JSX may write on each tag. For React 19 and others whose JSX types are in a module, extend theirs by these. */
import type { settingsFields } from '@ray-scene/core';
import type { SceneElementProperties } from './scene-elements.ts';

type Kebab<S extends string> = S extends `${infer Head}${infer Tail}`
  ? Tail extends Uncapitalize<Tail>
    ? `${Lowercase<Head>}${Kebab<Tail>}`
    : `${Lowercase<Head>}-${Kebab<Tail>}`
  : S;

/** Properties by their own names, and as attributes. */
type Fields<P> = { [K in keyof P]?: P[K] | string | undefined } & {
  [K in keyof P & string as Kebab<K>]?: P[K] | string | undefined;
};

interface AnyElement {
  readonly children?: unknown;
  readonly key?: string | number | null | undefined;
  readonly ref?: unknown;
  readonly id?: string | undefined;
  readonly class?: string | undefined;
  readonly className?: string | undefined;
  readonly style?: unknown;
  readonly slot?: string | undefined;
  readonly part?: string | undefined;
  readonly title?: string | undefined;
  readonly lang?: string | undefined;
  readonly hidden?: boolean | undefined;
  readonly role?: string | undefined;
  readonly tabIndex?: number | undefined;
  readonly tabindex?: number | string | undefined;
  readonly [prefixed: `${'aria' | 'data'}-${string}` | `on${string}`]: unknown;
}

type RaySceneAttributes = Fields<{
  -readonly [K in keyof typeof settingsFields]: (typeof settingsFields)[K]['default'];
}> &
  Fields<{
    src: string;
    alt: string;
    poster: string;
    background: readonly [number, number, number];
    scene: object;
    loading: 'eager' | 'lazy';
    cameraControls: boolean;
    autoRotate: boolean;
    paused: boolean;
    showStats: boolean;
  }> & { readonly crossOrigin?: string; readonly crossorigin?: string };

/** By tag, its attributes and properties. */
export type RaySceneIntrinsicElements = { 'ray-scene': AnyElement & RaySceneAttributes } & {
  [Tag in keyof SceneElementProperties]: AnyElement & Fields<SceneElementProperties[Tag]>;
};

declare global {
  namespace JSX {
    interface IntrinsicElements extends RaySceneIntrinsicElements {}
  }
}
